// SPDX-License-Identifier: MIT
#include <plumb/ballistics/beam.h>

#include <cmath>

#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/level.h>

namespace plumb {

std::optional<Shot> aimBeam(const BeamAim& problem) {
    detail::requireSize(problem.target, "BeamAim", ".target");
    detail::requireSize(problem.targetVelocity, "BeamAim", ".targetVelocity");
    detail::requireSize(problem.shooterVelocity, "BeamAim", ".shooterVelocity");
    detail::requireAmount(problem.speed, "BeamAim", ".speed");

    const double v = problem.speed;
    const double distance = detail::lengthOf(problem.target);
    if (distance <= detail::muzzle) return Shot{Vec2(v, 0) + problem.shooterVelocity, 0};
    // Parts of the target's velocity: away from the muzzle, and across.
    const Vec2 n = detail::directionOf(problem.target);
    const Vec2 w = problem.targetVelocity - problem.shooterVelocity;
    const double away = n.dot(w);
    const double aside = std::fabs(cross(n, w));
    if (v < aside) return std::nullopt;
    const double root = std::sqrt(v - aside) * std::sqrt(v + aside);
    const double speed = detail::lengthOf(w);
    // How fast the two come together: S - n . w, the larger of the two solutions.
    const double closing = away <= 0 ? root - away : (v - speed) * ((v + speed) / (root + away));
    const double time = distance / closing;
    if (!(closing > 0) || !std::isfinite(time)) return std::nullopt;
    return Shot{detail::withLength(closing * n + w, v) + problem.shooterVelocity, time};
}

}  // namespace plumb
