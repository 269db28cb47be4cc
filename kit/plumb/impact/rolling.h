// SPDX-License-Identifier: MIT
// When does a round object that slides on a floor begin to roll, and does it roll or slide down a slope?
#pragma once
#include <optional>

namespace plumb {

struct SlidingDisc {
    double speed = 3;            ///< v0, to +x [m/s]
    double angularVelocity = 0;  ///< w0; rolling to +x it is negative [rad/s]
    double radius = 0.5;         ///< r, > 0 [m]
    double inertiaRatio = 0.5;   ///< k = I / (m r^2): 1/2 for a full disc, 1 for a ring, 2/5 for a ball, > 0 [-]
    double friction = 0.2;       ///< mu, >= 0 [-]
    double gravity = 9.81;       ///< g, > 0 [m/s^2]
};

struct Rolling {
    double time = 0;             ///< time at which rolling begins [s]
    double distance = 0;         ///< sliding distance until then, to +x; negative with enough back spin [m]
    double speed = 0;            ///< from then on, to +x [m/s]
    double angularVelocity = 0;  ///< from then on, -speed / radius [rad/s]
};

/// s = v0 + w0 r,  t = |s| k / ((1 + k) mu g),  v = (v0 - k w0 r) / (1 + k),  x = (v0 + v) t / 2
/// s slip [m/s], t, v, x the time, speed and distance of Rolling. Empty when it slips without friction.
/// Source: Coriolis, "Theorie mathematique des effets du jeu de billard", 1835; the angular momentum about the floor
/// is kept: v - k w r. Throws std::invalid_argument on numbers that are not as above. Test: "a disc thrown at 3 m/s
/// with a friction of 0.2 rolls at 2 m/s after 0.5096839959 s, 1.2742099898 m on"
std::optional<Rolling> slideToRoll(const SlidingDisc& disc);

/// A round object released on a slope.
struct Incline {
    double angle = 0.5;         ///< a, of the slope, 0 to pi/2 [rad]
    double inertiaRatio = 0.5;  ///< k, as in SlidingDisc, > 0 [-]
    double friction = 0.5;      ///< mu, >= 0 [-]
    double gravity = 9.81;      ///< g, > 0 [m/s^2]
};

struct Descent {
    double acceleration = 0;  ///< of its centre, down the slope [m/s^2]
    double spinUp = 0;        ///< angular acceleration times radius; less than acceleration when it slides [m/s^2]
    bool rolls = false;
};

/// Rolling: g sin a / (1 + k), where friction is sufficient: mu >= tan a k / (1 + k); otherwise it slides and turns,
///   acceleration = g (sin a - mu cos a),  spinUp = mu g cos a / k
/// Symbols as in Incline. Source: textbook; Newton's law and Euler's with the friction that prevents slipping, or the
/// largest possible one. Throws std::invalid_argument on numbers that are not as above. Tests: "down 30 degrees a disc
/// rolls at 3.27, a ring at 2.4525, a ball at 3.5035714286 m/s^2", "100,000 descents obey Newton and Euler"
Descent rollDown(const Incline& incline);

/// The least friction coefficient for rolling: tan a k / (1 + k) [-]; a, k as in Incline, a below pi/2. Throws as
/// above.
double frictionToRoll(double angle, double inertiaRatio);

}  // namespace plumb
