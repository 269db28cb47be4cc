// SPDX-License-Identifier: MIT
#include <plumb/steering/seek.h>

#include <algorithm>
#include <string_view>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>

namespace plumb {

namespace {

/// The displacement from an agent to a point.
Vec2 displacementTo(const Agent& agent, const Vec2& point, std::string_view field) {
    validate(agent);
    requireFinite(point, field);
    const Vec2 displacement = point - agent.position;
    requireFinite(displacement, field, " - Agent.position");
    return displacement;
}

}  // namespace

Vec2 seek(const Agent& agent, const Vec2& target) {
    const Vec2 direction = detail::directionOf(displacementTo(agent, target, "seek: target"));
    if (direction.isZero(0)) return {0, 0};
    return steerTo(agent, agent.maxSpeed * direction);
}

Vec2 flee(const Agent& agent, const Vec2& threat) {
    const Vec2 direction = -detail::directionOf(displacementTo(agent, threat, "flee: threat"));
    return steerTo(agent, agent.maxSpeed * (direction.isZero(0) ? headingOf(agent) : direction));
}

double slowingDistanceOf(const Agent& agent) {
    validate(agent);
    return 4 * agent.maxSpeed * std::max(agent.responseTime, agent.maxSpeed / (2 * agent.maxAcceleration));
}

Vec2 arrive(const Agent& agent, const Vec2& target, std::optional<double> slowingDistance) {
    if (slowingDistance) requirePositive(*slowingDistance, "arrive: slowingDistance");
    const double slowing = slowingDistance ? *slowingDistance : slowingDistanceOf(agent);
    const Vec2 displacement = displacementTo(agent, target, "arrive: target");
    const bool near = detail::lengthOf(displacement) < slowing;
    return steerTo(agent, agent.maxSpeed * (near ? Vec2(displacement / slowing) : detail::directionOf(displacement)));
}

}  // namespace plumb
