// SPDX-License-Identifier: MIT
#include <plumb/steering/blend.h>

#include <plumb/math/check.h>
#include <plumb/steering/detail/vectors.h>

namespace plumb {
namespace {

Vec2 weighted(const Wish& wish) {
    requireNotNegative(wish.weight, "Wish", ".weight");
    requireFinite(wish.acceleration, "Wish", ".acceleration");
    const Vec2 wanted = wish.weight * wish.acceleration;
    requireFinite(wanted, "Wish", ".weight * acceleration");
    return wanted;
}

}  // namespace

Vec2 steerByWeight(const Agent& agent, std::span<const Wish> wishes) {
    validate(agent);
    Vec2 sum(0, 0);
    for (const Wish& wish : wishes) sum += weighted(wish);
    requireFinite(sum, "steerByWeight: sum");
    return detail::limited(sum, agent.maxAcceleration);
}

Vec2 steerByBudget(const Agent& agent, std::span<const Wish> wishes) {
    validate(agent);
    Vec2 sum(0, 0);
    double left = agent.maxAcceleration;
    for (const Wish& wish : wishes) {
        const Vec2 granted = detail::limited(weighted(wish), left);
        sum += granted;
        left -= detail::lengthOf(granted);
        if (!(left > 0)) break;
    }
    return detail::limited(sum, agent.maxAcceleration);
}

Vec2 steerByPriority(const Agent& agent, std::span<const Wish> wishes) {
    validate(agent);
    for (const Wish& wish : wishes) {
        const Vec2 wanted = weighted(wish);
        if (!wanted.isZero(0)) return detail::limited(wanted, agent.maxAcceleration);
    }
    return {0, 0};
}

}  // namespace plumb
