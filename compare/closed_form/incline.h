// SPDX-License-Identifier: MIT
// How fast does a thing gain speed down an incline?
#pragma once

namespace plumb::compare {

struct Incline {
    double angle = 0.5;     ///< from level, 0 to pi / 2 [rad]
    double gravity = 9.81;  ///< [m/s^2]
};

/// a = g (sin t - mu cos t) where tan t > mu, else 0: the block sticks.
/// a along the incline, downhill [m/s^2], t angle [rad], mu friction [-], g gravity [m/s^2]
/// Source: Coulomb; N = m g cos t. Holds for a block at rest at first that does not tip.
/// Test: "a block with a friction of 0.3 on 30 degrees gains 2.3562872367 m/s^2"
double slidingAcceleration(const Incline& incline, double friction);

/// a = g sin t / (1 + k),  k = I / (m r^2); turning at a / r.
/// I inertia about the centre [kg m^2], m mass [kg], r radius [m]; 1/2 for a disc
/// Source: textbook. Holds while it does not slip: mu >= k tan t / (1 + k).
/// Test: "a disc on 30 degrees gains 3.27 m/s^2, a ring 2.4525, a ball 3.5035714286"
double rollingAcceleration(const Incline& incline, double inertiaRatio);

}  // namespace plumb::compare
