// SPDX-License-Identifier: MIT
#include <plumb/steering/seek.h>

#include <algorithm>

#include <plumb/math/check.h>
#include <plumb/steering/detail/vectors.h>

namespace plumb {

Vec2 seek(const Agent& agent, const Vec2& target) {
    const Vec2 direction = detail::directionOf(target - agent.position);
    if (direction.isZero(0)) return {0, 0};
    return steerTo(agent, agent.maxSpeed * direction);
}

Vec2 flee(const Agent& agent, const Vec2& threat) {
    const Vec2 direction = detail::directionOf(agent.position - threat);
    return steerTo(agent, agent.maxSpeed * (direction.isZero(0) ? headingOf(agent) : direction));
}

double slowingDistanceOf(const Agent& agent) {
    validate(agent);
    return 4 * agent.maxSpeed * std::max(agent.responseTime, agent.maxSpeed / (2 * agent.maxAcceleration));
}

Vec2 arrive(const Agent& agent, const Vec2& target, std::optional<double> slowingDistance) {
    if (slowingDistance) requirePositive(*slowingDistance, "arrive: slowingDistance");
    const double slowing = slowingDistance ? *slowingDistance : slowingDistanceOf(agent);
    const Vec2 wanted = (target - agent.position) * (agent.maxSpeed / slowing);
    return steerTo(agent, detail::limited(wanted, agent.maxSpeed));
}

}  // namespace plumb
