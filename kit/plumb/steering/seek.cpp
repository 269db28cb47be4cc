// SPDX-License-Identifier: MIT
#include <plumb/steering/seek.h>

#include <algorithm>
#include <string_view>

#include <plumb/math/check.h>
#include <plumb/steering/detail/vectors.h>

namespace plumb {

namespace {

/// From an agent to a place.
Vec2 wayTo(const Agent& agent, const Vec2& place, std::string_view field) {
    validate(agent);
    requireFinite(place, field);
    const Vec2 way = place - agent.position;
    requireFinite(way, field, " - Agent.position");
    return way;
}

}  // namespace

Vec2 seek(const Agent& agent, const Vec2& target) {
    const Vec2 direction = detail::directionOf(wayTo(agent, target, "seek: target"));
    if (direction.isZero(0)) return {0, 0};
    return steerTo(agent, agent.maxSpeed * direction);
}

Vec2 flee(const Agent& agent, const Vec2& threat) {
    const Vec2 direction = -detail::directionOf(wayTo(agent, threat, "flee: threat"));
    return steerTo(agent, agent.maxSpeed * (direction.isZero(0) ? headingOf(agent) : direction));
}

double slowingDistanceOf(const Agent& agent) {
    validate(agent);
    return 4 * agent.maxSpeed * std::max(agent.responseTime, agent.maxSpeed / (2 * agent.maxAcceleration));
}

Vec2 arrive(const Agent& agent, const Vec2& target, std::optional<double> slowingDistance) {
    if (slowingDistance) requirePositive(*slowingDistance, "arrive: slowingDistance");
    const double slowing = slowingDistance ? *slowingDistance : slowingDistanceOf(agent);
    const Vec2 way = wayTo(agent, target, "arrive: target");
    const bool near = detail::lengthOf(way) < slowing;
    return steerTo(agent, agent.maxSpeed * (near ? Vec2(way / slowing) : detail::directionOf(way)));
}

}  // namespace plumb
