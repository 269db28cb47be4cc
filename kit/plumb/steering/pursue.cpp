// SPDX-License-Identifier: MIT
#include <plumb/steering/pursue.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>
#include <plumb/steering/seek.h>

namespace plumb {
namespace {

/// The time at which an agent with this speed meets a target at d with velocity w; most if it does not meet it within
/// that time.
double meetingTime(const Vec2& d, const Vec2& w, double speed, double most) {
    if (d.isZero(0)) return 0;
    const double along = d.dot(w);
    const double discriminant = along * along + (speed * speed - w.squaredNorm()) * d.squaredNorm();
    if (!(discriminant >= 0)) return most;
    const double divisor = std::sqrt(discriminant) - along;
    return divisor > 0 ? std::min(most, d.squaredNorm() / divisor) : most;
}

/// The direction sideways out of the way of a pursuer with velocity w, for an agent at the offset back from it.
Vec2 aside(const Vec2& w, const Vec2& back) {
    const Vec2 left = perp(detail::directionOf(w));
    return cross(w, back) >= 0 ? left : Vec2(-left);
}

}  // namespace

void validate(const AgentState& seen, std::string_view field) {
    requireFinite(seen.position, field, ".position");
    requireFinite(seen.velocity, field, ".velocity");
}

Vec2 pursue(const Agent& agent, const AgentState& quarry, double mostAhead) {
    validate(agent);
    validate(quarry);
    requireNotNegative(mostAhead, "pursue: mostAhead");
    const Vec2 d = quarry.position - agent.position;
    return seek(agent, quarry.position + meetingTime(d, quarry.velocity, agent.maxSpeed, mostAhead) * quarry.velocity);
}

Vec2 evade(const Agent& agent, const AgentState& pursuer, double mostAhead) {
    validate(agent);
    validate(pursuer);
    requireNotNegative(mostAhead, "evade: mostAhead");
    const Vec2 back = agent.position - pursuer.position;
    const double distance = detail::lengthOf(back), speed = detail::lengthOf(pursuer.velocity);
    if (speed > agent.maxSpeed && pursuer.velocity.dot(back) > 0 && distance < mostAhead * speed)
        return steerTo(agent, agent.maxSpeed * aside(pursuer.velocity, back));
    const double time = std::min(mostAhead, distance / (agent.maxSpeed + speed));
    return flee(agent, pursuer.position + time * pursuer.velocity);
}

}  // namespace plumb
