// SPDX-License-Identifier: MIT
// Which is the slowest shot that hits a target?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct SlowestAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// Of speed 0 when the target is straight below. Empty without gravity, where there is no slowest shot.
///   v^2 = |g| D - g . d,  t^2 = 2 D / |g|
/// v speed [m/s], g gravity [m/s^2], d target [m], D its distance [m], t time [s]. The direction of the shot bisects
/// the angle between straight up and the target. Throws std::invalid_argument on input out of range (shot.h). Source:
/// the case in which the two arcs of fixed speed coincide. Test: "a million slowest shots hit, and slower ones do not"
std::optional<Shot> aimSlowest(const SlowestAim& problem);

}  // namespace plumb
