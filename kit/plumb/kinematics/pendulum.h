// SPDX-License-Identifier: MIT
// What is the period of a pendulum?
#pragma once
#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>

namespace plumb {

/// A rigid body that hangs on an axis; a bob on a thread of length L has inertia m L^2 and distance L.
struct Pendulum {
    double inertia = 1;     ///< I, about the axis, > 0 [kg m^2]
    double mass = 1;        ///< m, > 0 [kg]
    double distance = 1;    ///< l, from the axis to the centre of mass, > 0 [m]
    double gravity = 9.81;  ///< g, > 0 [m/s^2]
};

/// T = 2 pi sqrt(I / (m g l)) / AGM(1, cos(A / 2)), for small swings 2 pi sqrt(I / (m g l)) (1 + A^2 / 16 + ...)
/// T period [s], A amplitude, the largest angle, of either sign, less than pi in size [rad], AGM the
/// arithmetic-geometric mean [-], the rest as in Pendulum. Without damping. Relative error below 1e-14.
/// Source: Carvalhaes and Suppes, "Approximations for the period of the simple pendulum based on the
/// arithmetic-geometric mean", Am. J. Phys. 76, 2008. Throws std::invalid_argument on numbers that are not as above,
/// and where the period is not finite. Test: "a pendulum's period is its elliptic integral, and the series' for small
/// swings"
inline double pendulumPeriod(const Pendulum& pendulum, double amplitude = 0) {
    requirePositive(pendulum.inertia, "Pendulum", ".inertia");
    requirePositive(pendulum.mass, "Pendulum", ".mass");
    requirePositive(pendulum.distance, "Pendulum", ".distance");
    requirePositive(pendulum.gravity, "Pendulum", ".gravity");
    requireFinite(amplitude, "pendulumPeriod: amplitude");
    if (!(std::fabs(amplitude) < std::numbers::pi))
        refuse("pendulumPeriod: amplitude", toText(amplitude) + " is not between -pi and pi");
    const double square = pendulum.inertia / pendulum.mass / pendulum.distance / pendulum.gravity;
    const double small = 2 * std::numbers::pi * std::sqrt(square);
    // The arithmetic-geometric mean of the two, the larger first. Each iteration about doubles the number of digits
    // that they have in common.
    double a = 1, b = sinCos(0.5 * std::fabs(amplitude)).cos;
    for (int i = 0; i < 40 && a - b > 1e-8 * a; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    const double period = small / (0.5 * (a + b));
    requireFinite(period, "pendulumPeriod: period");
    return period;
}

}  // namespace plumb
