// SPDX-License-Identifier: MIT
#include <plumb/kinematics/pendulum.h>

#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {
namespace {

/// Of two positive numbers, the larger first. Each iteration about doubles the number of digits that the two have in
/// common.
double arithmeticGeometricMean(double a, double b) {
    for (int i = 0; i < 40 && a - b > 1e-8 * a; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return 0.5 * (a + b);
}

}  // namespace

double pendulumPeriod(const Pendulum& pendulum, double amplitude) {
    requirePositive(pendulum.inertia, "Pendulum", ".inertia");
    requirePositive(pendulum.mass, "Pendulum", ".mass");
    requirePositive(pendulum.distance, "Pendulum", ".distance");
    requirePositive(pendulum.gravity, "Pendulum", ".gravity");
    requireFinite(amplitude, "pendulumPeriod: amplitude");
    if (!(std::fabs(amplitude) < std::numbers::pi))
        refuse("pendulumPeriod: amplitude", toText(amplitude) + " is not between -pi and pi");
    const double square = pendulum.inertia / pendulum.mass / pendulum.distance / pendulum.gravity;
    const double small = 2 * std::numbers::pi * std::sqrt(square);
    const double period = small / arithmeticGeometricMean(1, sinCos(0.5 * std::fabs(amplitude)).cos);
    requireFinite(period, "pendulumPeriod: period");
    return period;
}

}  // namespace plumb
