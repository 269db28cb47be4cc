// SPDX-License-Identifier: MIT
#include <plumb/ballistics/fixed_angle.h>

#include <cmath>

#include <plumb/ballistics/detail/input.h>
#include <plumb/math/trig.h>

namespace plumb {

std::optional<Shot> aimAtAngle(const AngleAim& problem) {
    detail::requireSize(problem.target, "AngleAim", ".target");
    detail::requireSize(problem.angle, "AngleAim", ".angle");
    detail::requireSize(problem.gravity, "AngleAim", ".gravity");

    const SinCos turn = sinCos(problem.angle);
    const Vec2 n(turn.cos, turn.sin);
    const double fall = cross(n, problem.gravity);
    const double time = std::sqrt(2 * (cross(n, problem.target) / fall));
    const double speed = cross(problem.target, problem.gravity) / (time * fall);
    // Infinite or NaN when the barrel points along gravity, straight at the target, or above the possible angles.
    if (!(speed > 0 && std::isfinite(speed) && std::isfinite(time))) return std::nullopt;
    return Shot{speed * n, time};
}

}  // namespace plumb
