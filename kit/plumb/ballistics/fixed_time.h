// SPDX-License-Identifier: MIT
// Which shot reaches a target after a given time?
#pragma once
#include <plumb/ballistics/shot.h>

namespace plumb {

struct TimeAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double time = 1;         ///< to the target, > 0 [s]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// There always is exactly one:
///   u = d / t - g t / 2
/// u velocity [m/s], d target [m], t time [s], g gravity [m/s^2]. For a moving target, pass its position at that time.
/// Throws std::invalid_argument on input out of range (shot.h).
/// Test: "a million shots of fixed time are at their target then"
Shot aimInTime(const TimeAim& problem);

}  // namespace plumb
