// SPDX-License-Identifier: MIT
#include <plumb/steering/blend.h>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>

namespace plumb {
namespace {

Vec2 weighted(const WeightedSteering& request) {
    requireNotNegative(request.weight, "WeightedSteering", ".weight");
    requireFinite(request.acceleration, "WeightedSteering", ".acceleration");
    const Vec2 wanted = request.weight * request.acceleration;
    requireFinite(wanted, "WeightedSteering", ".weight * acceleration");
    return wanted;
}

}  // namespace

Vec2 steerByWeight(const Agent& agent, std::span<const WeightedSteering> requests) {
    validate(agent);
    Vec2 sum(0, 0);
    for (const WeightedSteering& request : requests) sum += weighted(request);
    requireFinite(sum, "steerByWeight: sum");
    return detail::limited(sum, agent.maxAcceleration);
}

Vec2 steerByBudget(const Agent& agent, std::span<const WeightedSteering> requests) {
    validate(agent);
    Vec2 sum(0, 0);
    double left = agent.maxAcceleration;
    for (const WeightedSteering& request : requests) {
        const Vec2 granted = detail::limited(weighted(request), left);
        sum += granted;
        left -= detail::lengthOf(granted);
        if (!(left > 0)) break;
    }
    return detail::limited(sum, agent.maxAcceleration);
}

Vec2 steerByPriority(const Agent& agent, std::span<const WeightedSteering> requests) {
    validate(agent);
    for (const WeightedSteering& request : requests) {
        const Vec2 wanted = weighted(request);
        if (!wanted.isZero(0)) return detail::limited(wanted, agent.maxAcceleration);
    }
    return {0, 0};
}

}  // namespace plumb
