// SPDX-License-Identifier: MIT
// Which shot with a given apex hits a target on its way down?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct ApexAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double apex = 0;         ///< the highest point of the trajectory above the muzzle, >= 0 [m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// Empty when the target is above the apex, when the shot has no time to get there (a target at the muzzle's height,
/// apex 0), and without gravity.
///   w = sqrt(2 |g| H),  t = w / |g| + sqrt(2 (H - y) / |g|),  the horizontal velocity is x / t
/// w upward velocity [m/s], g gravity [m/s^2], H apex [m], (x, y) target, horizontal and up [m], t time [s]. Throws
/// std::invalid_argument on input out of range (shot.h). Test: "a million shots over a given apex hit, and rise just so
/// high"
std::optional<Shot> aimByApex(const ApexAim& problem);

}  // namespace plumb
