// SPDX-License-Identifier: MIT
// How high does a block swing after a bullet gets stuck in it?
#pragma once

namespace plumb::compare {

/// The block hangs on parallel rods, so that it does not turn.
struct BallisticPendulum {
    double bullet = 0.01;   ///< m [kg]
    double block = 1;       ///< M [kg]
    double speed = 100;     ///< v of the bullet, horizontal [m/s]
    double length = 1;      ///< of the rods [m]
    double gravity = 9.81;  ///< [m/s^2]
};

/// h = (m v / (m + M))^2 / (2 g) [m].
/// Source: Robins 1742; momentum is kept while the bullet stops in the block, and energy after that.
/// Test: "a bullet of 10 g at 100.04 m/s lifts a block of 1 kg by 5 cm"
double riseOf(const BallisticPendulum& pendulum);

/// acos(1 - h / l), the angle of the rods from straight down [rad]. Holds: h < 2 l.
double amplitudeOf(const BallisticPendulum& pendulum);

}  // namespace plumb::compare
