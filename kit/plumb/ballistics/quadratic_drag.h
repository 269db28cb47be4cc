// SPDX-License-Identifier: MIT
// How does a shot fly straight up, and fall, with drag proportional to the square of its speed?
#pragma once

namespace plumb {

struct QuadraticDrag {
    double coefficient = 0;  ///< drag over (mass times speed squared), rho C A / (2 m); 0, or at least 1e-50 [1/m]
    double gravity = 9.81;   ///< > 0 [m/s^2]
};

/// The speed at which drag balances the weight: sqrt(g / c) [m/s], c coefficient [1/m], g gravity [m/s^2]; infinite
/// without drag.
/// Throws std::invalid_argument on input out of range (shot.h), as all functions here.
double terminalSpeed(const QuadraticDrag& drag);

struct VerticalShot {
    double riseTime = 0;     ///< up to the apex [s]
    double height = 0;       ///< of the apex [m]
    double fallTime = 0;     ///< from the apex back to the muzzle [s]
    double returnSpeed = 0;  ///< at the muzzle [m/s]
};

/// A shot straight up and its return.
///   t = (V / g) atan(u / V),  H = (V^2 / (2 g)) ln(1 + (u / V)^2),  u' = u V / sqrt(u^2 + V^2)
///   t' = (V / g) artanh(u' / V)
/// t, t' times up and down [s], H height [m], u, u' speeds at the launch and the return [m/s], V terminal speed
/// [m/s], g gravity [m/s^2]; without drag their limits, t = t' = u / g, H = u^2 / (2 g), u' = u. Throws as above.
/// Source: v' = -g - c v |v|. Tests: "without drag a shot up and a fall are those of the textbook", "10,000 vertical
/// shots through quadratic drag agree with a Runge-Kutta method of order 4"
VerticalShot shootUp(double speed, const QuadraticDrag& drag);

struct Fall {
    double distance = 0;  ///< [m]
    double speed = 0;     ///< [m/s]
};

/// The fall from rest after a time.
///   v = V tanh(g t / V),  s = (V^2 / g) ln cosh(g t / V)
/// v speed [m/s], s distance [m], V terminal speed [m/s], g gravity [m/s^2], t time [s]; without drag g t and
/// g t^2 / 2. Throws, source, tests as above.
Fall fallFor(double time, const QuadraticDrag& drag);

}  // namespace plumb
