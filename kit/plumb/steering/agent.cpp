// SPDX-License-Identifier: MIT
#include <plumb/steering/agent.h>

#include <plumb/math/check.h>
#include <plumb/steering/detail/vectors.h>

namespace plumb {

void validate(const Agent& agent, std::string_view field) {
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
    const Vec2 wanted = (wantedVelocity - agent.velocity) / agent.responseTime;
    return detail::limited(wanted, agent.maxAcceleration);
}

Agent moved(const Agent& agent, const Vec2& acceleration, double dt) {
    validate(agent);
    requireNotNegative(dt, "moved: dt");
    Agent after = agent;
    after.velocity = detail::limited(agent.velocity + acceleration * dt, agent.maxSpeed);
    after.position += (agent.velocity + after.velocity) * (dt / 2);
    return after;
}

}  // namespace plumb
