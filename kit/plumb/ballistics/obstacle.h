// SPDX-License-Identifier: MIT
// How must a shot be aimed to hit a target behind a wall?
#pragma once
#include <optional>
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct WallAim {
    Vec2 target{0, 0};          ///< from the muzzle [m]
    std::vector<Vec2> walls{};  ///< tops to fly over; a thick wall has two: its upper corners [m]
    double margin = 0;          ///< vertical distance kept above each top, >= 0 [m]
    double speed = 0;           ///< for aimOver only, >= 0 [m/s]
    Vec2 gravity{0, -9.81};     ///< [m/s^2]
};

/// Those of aim()'s shots that clear every wall by the margin, to rounding: a wall that is not between muzzle and
/// target is always cleared. A speed within 1e-15 of aimSlowestOver()'s counts as equal to it: one shot. Throws
/// std::invalid_argument on input out of range (shot.h). Tests: "a million shots over a wall hit and clear it, and no
/// other angle does", "the slowest shot's own speed has a shot over the wall, a million times"
std::vector<Shot> aimOver(const WallAim& problem);

/// The slowest shot that hits and clears every wall; it is aimSlowest()'s, or touches the margin of one wall. Empty
/// without gravity. Throws as above.
///   tan a = (h x^2 - y z^2) / (z x (x - z)),  v^2 = |g| x^2 (1 + tan^2 a) / (2 (x tan a - y))
/// (x, y) target, (z, h) top with its margin, horizontal and vertical [m], a angle [rad], v speed [m/s], g gravity
/// [m/s^2]. Source: the parabola through three points; at a wall every steeper one is higher, and v^2 has one minimum
/// over a. Test: "a million slowest shots over a wall hit and clear it, and slower ones do not"
std::optional<Shot> aimSlowestOver(const WallAim& problem);

}  // namespace plumb
