// SPDX-License-Identifier: MIT
#include <plumb/ballistics/fixed_speed.h>

#include <cmath>

#include <plumb/ballistics/detail/gravity_frame.h>
#include <plumb/ballistics/detail/input.h>

namespace plumb {

std::vector<Shot> aim(const Aim& problem) {
    detail::requireSize(problem.target, "Aim", ".target");
    detail::requireAmount(problem.speed, "Aim", ".speed");
    detail::requireSize(problem.gravity, "Aim", ".gravity");

    const Vec2& d = problem.target;
    const Vec2& g = problem.gravity;
    const double v = problem.speed;
    const double distance = detail::lengthOf(d);
    if (distance <= detail::muzzle) return {{v * detail::GravityFrame(g).up, 0}};
    const double gravity = detail::lengthOf(g);
    const double least = detail::leastSpeedSquared(d, distance, g, gravity);
    double spare = v * v - least;
    if (std::fabs(spare) <= 2e-15 * least) spare = 0;
    if (spare < 0) return {};

    const double b = v * v + g.dot(d);
    const double sum = b + std::sqrt(spare) * std::sqrt(b + gravity * distance);  // B + S
    std::vector<Shot> shots;
    const auto add = [&](double t) {
        if (std::isfinite(t)) shots.push_back({detail::withLength(d / t - 0.5 * t * g, v), t});
    };
    if (sum > 0) add(distance * std::sqrt(2 / sum));
    if (spare > 0 && gravity > 0) add(std::sqrt(2 * sum) / gravity);
    return shots;
}

}  // namespace plumb
