// SPDX-License-Identifier: MIT
#include <compare/formula/kepler.h>

#include <cmath>
#include <numbers>

namespace plumb::compare {
namespace {

/// Solves E - e sin E = mean for E; the left side grows with E.
double eccentricAnomaly(double mean, double e) {
    double low = mean - 1, high = mean + 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (middle - e * std::sin(middle) < mean ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

KeplerState keplerState(const KeplerOrbit& orbit, double time) {
    const double turn = 2 * std::numbers::pi / orbit.period;
    const double e = orbit.eccentricity, a = orbit.semiMajorAxis;
    const double anomaly = eccentricAnomaly(std::remainder(turn * time, 2 * std::numbers::pi), e);
    const double cosine = std::cos(anomaly), sine = std::sin(anomaly);
    const double narrow = std::sqrt((1 - e) * (1 + e));
    const double rate = turn / (1 - e * cosine);
    return {{a * (cosine - e), a * narrow * sine}, {-a * sine * rate, a * narrow * cosine * rate}};
}

}  // namespace plumb::compare
