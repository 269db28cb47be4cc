// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/orbits.h>

#include <cmath>
#include <numbers>

#include <compare/formula/kepler.h>

namespace plumb::compare {
namespace {

constexpr double turn = 2 * std::numbers::pi;  // [s]

}  // namespace

MotionProblem oscillator() {
    const auto energy = [](const Motion& motion) {
        return 0.5 * (motion.velocity.squaredNorm() + motion.position.squaredNorm());
    };
    return {.name = "oscillator",
            .acceleration = [](const Vec2& position) -> Vec2 { return -position; },
            .start = {{1, 0}, {0, 0}},
            .energy = energy,
            .truePosition = [](double time) { return Vec2(std::cos(time), 0); },
            .period = turn};
}

MotionProblem keplerOrbit(double eccentricity) {
    const KeplerOrbit orbit{.eccentricity = eccentricity, .period = turn};
    const auto acceleration = [](const Vec2& position) -> Vec2 {
        const double distance = position.norm();
        return -position / (distance * distance * distance);
    };
    const auto energy = [](const Motion& motion) {
        return 0.5 * motion.velocity.squaredNorm() - 1 / motion.position.norm();
    };
    const double nearest = 1 - eccentricity;
    return {.name = "orbit",
            .acceleration = acceleration,
            .start = {{nearest, 0}, {0, std::sqrt((1 + eccentricity) / nearest)}},
            .energy = energy,
            .truePosition = [orbit](double time) { return keplerState(orbit, time).position; },
            .period = turn};
}

}  // namespace plumb::compare
