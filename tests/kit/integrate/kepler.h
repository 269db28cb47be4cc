// SPDX-License-Identifier: MIT
// Where is a planet, by the textbook?
#pragma once
#include <plumb/integrate/symplectic.h>
#include <plumb/math/vec2.h>

#include <cmath>
#include <numbers>

namespace plumb::test {

/// About a sun of G M = 1 at the origin, with semi-major axis 1 and eccentricity 0.5: a period of 2 pi, energy
/// -1/2 and angular momentum sqrt(3)/2. Time 0 is at perihelion, (0.5, 0).
inline Phase<Vec2> perihelion() {
    return {{0.5, 0}, {0, std::sqrt(3.0)}};
}
inline Vec2 sunsPull(double, const Vec2& position, const Vec2&) {
    const double r = position.norm();
    return -position / (r * r * r);
}
inline double energyOf(const Phase<Vec2>& phase) {
    return phase.velocity.squaredNorm() / 2 - 1 / phase.position.norm();
}

/// Kepler's equation M = E - e sin E, by Newton's method.
inline Phase<Vec2> planetAt(double time) {
    const double e = 0.5, mean = std::remainder(time, 2 * std::numbers::pi);
    double anomaly = mean;
    for (int i = 0; i < 20; ++i) anomaly -= (anomaly - e * std::sin(anomaly) - mean) / (1 - e * std::cos(anomaly));
    const double c = std::cos(anomaly), s = std::sin(anomaly), b = std::sqrt(1 - e * e), rate = 1 / (1 - e * c);
    return {{c - e, b * s}, {-s * rate, b * c * rate}};
}

}  // namespace plumb::test
