// SPDX-License-Identifier: MIT
// Where is a mass on a spring and a damper at time t?
#pragma once

namespace plumb::compare {

struct Oscillator {
    double mass = 1;       ///< m [kg]
    double stiffness = 1;  ///< k, > 0 [N/m]
    double damping = 0;    ///< c, >= 0 [N s/m]
    double offset = 0;     ///< x at t = 0, from where it rests [m]
    double speed = 0;      ///< x' at t = 0 [m/s]
};

struct Displacement {
    double value;  ///< x [m]
    double speed;  ///< x' [m/s]
};

/// x = e^(-b t) (x0 C + (v0 + b x0) S),  x' = e^(-b t) (v0 C - (w0^2 x0 + b v0) S),  b = c / (2 m), w0^2 = k / m
/// C, S = cos w t, sin(w t) / w with w^2 = w0^2 - b^2 if that is positive (it swings); 1, t if it is 0
/// (critical); cosh q t, sinh(q t) / q with q^2 = b^2 - w0^2 if it is negative (it creeps).
/// Source: textbook; m x'' = -k x - c x'. Exact to rounding.
/// Tests: "1 kg on 4 N/m with 0.4 N s/m is at -0.2580702634 m after 1 s",
///        "an oscillator's closed form solves its equation of motion, damped or not"
Displacement displacementAt(const Oscillator& oscillator, double t);

}  // namespace plumb::compare
