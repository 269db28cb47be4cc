// SPDX-License-Identifier: MIT
#include <plumb/steering/agent.h>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>

namespace plumb {

void validate(const Agent& agent, std::string_view field) {
    requireFinite(agent.position, field, ".position");
    requireFinite(agent.velocity, field, ".velocity");
    requireNotNegative(agent.radius, field, ".radius");
    requirePositive(agent.maxSpeed, field, ".maxSpeed");
    requirePositive(agent.maxAcceleration, field, ".maxAcceleration");
    requirePositive(agent.responseTime, field, ".responseTime");
}

Vec2 headingOf(const Agent& agent) {
    const Vec2 heading = detail::directionOf(agent.velocity);
    return heading.isZero(0) ? Vec2(1, 0) : heading;
}

Vec2 steerTo(const Agent& agent, const Vec2& wantedVelocity) {
    validate(agent);
    requireFinite(wantedVelocity, "steerTo: wantedVelocity");
    const Vec2 change = wantedVelocity - agent.velocity;
    const Vec2 wanted = change / agent.responseTime;
    if (!wanted.allFinite())  // overflow: more than the limit in any case
        return agent.maxAcceleration * detail::directionOf(0.5 * wantedVelocity - 0.5 * agent.velocity);
    return detail::limited(wanted, agent.maxAcceleration);
}

Agent moved(const Agent& agent, const Vec2& acceleration, double dt) {
    validate(agent);
    requireFinite(acceleration, "moved: acceleration");
    requireNotNegative(dt, "moved: dt");
    requireFinite(acceleration * dt, "moved: acceleration * dt");
    Agent after = agent;
    after.velocity = detail::limited(agent.velocity + acceleration * dt, agent.maxSpeed);
    after.position += (agent.velocity + after.velocity) * (dt / 2);
    return after;
}

}  // namespace plumb
