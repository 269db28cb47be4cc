// SPDX-License-Identifier: MIT
// Where does a spring, damped or not, move a body?
#pragma once
#include <optional>

#include <plumb/kinematics/point_motion.h>

namespace plumb {

/// Simple harmonic motion.
struct HarmonicMotion {
    double amplitude = 1;         ///< [m]
    double angularFrequency = 1;  ///< [rad/s]
    double phase = 0;             ///< [rad]
};

/// x = A cos(w t + p), v = -A w sin(w t + p)
/// x position from rest [m], v velocity [m/s], A amplitude [m], w angularFrequency, p phase [rad], t time [s].
/// Source: textbook. Throws std::invalid_argument on a number that is not finite, w t + p and A w included.
/// Test: "simple harmonic motion is what the exact step makes of it"
AxisMotion harmonicAt(const HarmonicMotion& motion, double time);

/// x'' + 2 z w x' + w^2 x = 0
struct Oscillator {
    double angularFrequency = 1;  ///< w, of the undamped spring, >= 0 [rad/s]
    double dampingRatio = 0;      ///< z: 0 undamped, below 1 underdamped, 1 critically damped, above 1 overdamped [-]
};

/// w = sqrt(k / m), z = c / (2 sqrt(k m)).
/// Throws std::invalid_argument unless mass [kg] and stiffness k [N/m] are positive and damping c [N s/m] is not
/// negative.
Oscillator oscillatorOf(double mass, double stiffness, double damping);

/// T = 2 pi / (w sqrt(1 - z^2)) [s]; empty when there is no oscillation, z >= 1 or w = 0. Throws as oscillatorStep
/// does.
/// Test: "a spring of 4 N/m and 0.4 N s/m takes 1 kg from 1 m to -0.2580702634 m in 1 s, its period is
/// 3.1574194170 s"
std::optional<double> dampedPeriod(const Oscillator& oscillator);

/// The effect of a time step on position and velocity: x = xx x0 + xv v0, v = vx x0 + vv v0, x from rest. It can be
/// reused as long as the time step is the same.
struct OscillatorStep {
    double xx = 1;  ///< [-]
    double xv = 0;  ///< [s]
    double vx = 0;  ///< [1/s]
    double vv = 1;  ///< [-]
};

/// The exact step of any length, underdamped, critical or overdamped: with s = w sqrt(1 - z^2) and E = e^(-z w t),
///   xx, vv = E (cos s t +- z w sin(s t) / s),  xv = E sin(s t) / s,  vx = -w^2 xv
/// and cosh, sinh for z > 1. Near z = 1 by the series of cos r and sin(r) / r in r^2, so it is smooth there; for z > 1
/// by the two decay rates, the slow one as w / (z + sqrt(z^2 - 1)). w, z as in Oscillator, t time, >= 0 [s].
/// Source: textbook. Holds for any damping; without a spring, w = 0, there is no damping either: use moveWithDrag.
/// Exact to the rounding of w t. Throws std::invalid_argument on a number that is negative or not finite, w t included.
/// Test: "an oscillator of any damping is where the matrix exponential takes it, 1,000,000 times"
OscillatorStep oscillatorStep(const Oscillator& oscillator, double time);

/// Applies the step: towards rest [m]. Both axes of a point in the same way.
AxisMotion oscillate(const AxisMotion& from, double rest, const Oscillator& oscillator, double time);
PointMotion oscillate(const PointMotion& from, const Vec2& rest, const Oscillator& oscillator, double time);

}  // namespace plumb
