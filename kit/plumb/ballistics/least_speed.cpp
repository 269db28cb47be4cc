// SPDX-License-Identifier: MIT
#include <plumb/ballistics/least_speed.h>

#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>

namespace plumb {

std::optional<Shot> aimSlowest(const SlowestAim& problem) {
    detail::requireSize(problem.target, "SlowestAim", ".target");
    detail::requireSize(problem.gravity, "SlowestAim", ".gravity");

    const Vec2& d = problem.target;
    const Vec2& g = problem.gravity;
    const double distance = detail::lengthOf(d);
    const double gravity = detail::lengthOf(g);
    if (distance == 0) return Shot{};
    const double time = std::sqrt(2 * (distance / gravity));
    if (!(time > 0 && std::isfinite(time))) return std::nullopt;
    const double speed = std::sqrt(detail::leastSpeedSquared(d, distance, g, gravity));
    return Shot{detail::withLength(d / time - 0.5 * time * g, speed), time};
}

}  // namespace plumb
