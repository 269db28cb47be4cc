// SPDX-License-Identifier: MIT
#include <plumb/ballistics/apex.h>

#include <cmath>

#include <plumb/ballistics/detail/input.h>
#include <plumb/ballistics/detail/level.h>

namespace plumb {

std::optional<Shot> aimByApex(const ApexAim& problem) {
    detail::requireSize(problem.target, "ApexAim", ".target");
    detail::requireAmount(problem.apex, "ApexAim", ".apex");
    detail::requireSize(problem.gravity, "ApexAim", ".gravity");

    const detail::Level level(problem.gravity);
    const double up = problem.target.dot(level.up);
    const double along = problem.target.dot(level.right);
    if (!(level.gravity > 0) || up > problem.apex) return std::nullopt;
    const double time =
        std::sqrt(2 * (problem.apex / level.gravity)) + std::sqrt(2 * ((problem.apex - up) / level.gravity));
    const double drift = along == 0 ? 0 : along / time;
    if (!std::isfinite(time) || !std::isfinite(drift)) return std::nullopt;
    return Shot{drift * level.right + std::sqrt(2 * level.gravity * problem.apex) * level.up, time};
}

}  // namespace plumb
