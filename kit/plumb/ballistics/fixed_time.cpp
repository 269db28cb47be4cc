// SPDX-License-Identifier: MIT
#include <plumb/ballistics/fixed_time.h>

#include <plumb/ballistics/detail/input.h>

namespace plumb {

Shot aimInTime(const TimeAim& problem) {
    detail::requireSize(problem.target, "TimeAim", ".target");
    detail::requirePositiveAmount(problem.time, "TimeAim", ".time");
    detail::requireSize(problem.gravity, "TimeAim", ".gravity");
    return {problem.target / problem.time - 0.5 * problem.time * problem.gravity, problem.time};
}

}  // namespace plumb
