// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/orbits.h>

#include <cmath>
#include <numbers>

namespace plumb::compare {
namespace {

/// Newton's method from E = t + e sin t, which for e = 0.5 is at the last bit after four rounds; it is given twenty.
double eccentricAnomaly(double time, double eccentricity) {
    double anomaly = time + eccentricity * std::sin(time);
    for (int round = 0; round < 20; ++round) {
        const double off = anomaly - eccentricity * std::sin(anomaly) - time;
        anomaly -= off / (1 - eccentricity * std::cos(anomaly));
    }
    return anomaly;
}

}  // namespace

MotionProblem oscillator() {
    return {
        .name = "oscillator",
        .acceleration = [](const Vec2& position) -> Vec2 { return -position; },
        .start = {{1, 0}, {0, 0}},
        .energy =
            [](const Motion& motion) { return 0.5 * (motion.velocity.squaredNorm() + motion.position.squaredNorm()); },
        .truePosition = [](double time) { return Vec2(std::cos(time), 0); },
        .period = 2 * std::numbers::pi};
}

MotionProblem keplerOrbit(double eccentricity) {
    const double e = eccentricity;
    return {
        .name = "orbit",
        .acceleration = [](const Vec2& position) -> Vec2 {
            const double distance = position.norm();
            return -position / (distance * distance * distance);
        },
        .start = {{1 - e, 0}, {0, std::sqrt((1 + e) / (1 - e))}},
        .energy = [](const Motion& motion) { return 0.5 * motion.velocity.squaredNorm() - 1 / motion.position.norm(); },
        .truePosition =
            [e](double time) {
                const double anomaly = eccentricAnomaly(time, e);
                return Vec2(std::cos(anomaly) - e, std::sqrt(1 - e * e) * std::sin(anomaly));
            },
        .period = 2 * std::numbers::pi};
}

}  // namespace plumb::compare
