// SPDX-License-Identifier: MIT
#include <plumb/ballistics/apex.h>

#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>

namespace plumb {

std::optional<Shot> aimByApex(const ApexAim& problem) {
    detail::requireSize(problem.target, "ApexAim", ".target");
    detail::requireAmount(problem.apex, "ApexAim", ".apex");
    detail::requireSize(problem.gravity, "ApexAim", ".gravity");

    const detail::GravityFrame frame(problem.gravity);
    const double up = problem.target.dot(frame.up);
    const double along = problem.target.dot(frame.right);
    if (!(frame.gravity > 0) || up > problem.apex) return std::nullopt;
    const double time =
        std::sqrt(2 * (problem.apex / frame.gravity)) + std::sqrt(2 * ((problem.apex - up) / frame.gravity));
    const double drift = along == 0 ? 0 : along / time;
    if (!std::isfinite(time) || !std::isfinite(drift)) return std::nullopt;
    return Shot{drift * frame.right + std::sqrt(2 * frame.gravity * problem.apex) * frame.up, time};
}

}  // namespace plumb
