// SPDX-License-Identifier: MIT
#include <plumb/ballistics/beam.h>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/straight_intercepts.h>

namespace plumb {

std::optional<Shot> aimBeam(const BeamAim& problem) {
    detail::requireSize(problem.target, "BeamAim", ".target");
    detail::requireSize(problem.targetVelocity, "BeamAim", ".targetVelocity");
    detail::requireSize(problem.shooterVelocity, "BeamAim", ".shooterVelocity");
    detail::requireAmount(problem.speed, "BeamAim", ".speed");

    const double v = problem.speed;
    if (detail::lengthOf(problem.target) <= detail::muzzle) return Shot{Vec2(v, 0) + problem.shooterVelocity, 0};
    const Vec2 w = problem.targetVelocity - problem.shooterVelocity;
    const detail::Intercepts found = detail::straightIntercepts(problem.target, w, v);
    if (found.count == 0) return std::nullopt;
    const detail::Intercepts::Intercept& first = found.intercepts[0];
    const Vec2 velocity = first.closing * detail::directionOf(problem.target) + w;
    return Shot{detail::withLength(velocity, v) + problem.shooterVelocity, first.time};
}

}  // namespace plumb
