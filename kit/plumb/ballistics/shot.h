// SPDX-License-Identifier: MIT
// What is the result of an aiming function?
// In this module the muzzle is at the origin and all positions are relative to it; a target within 1e-200 m is at the
// muzzle. Gravity is a vector of any direction, possibly zero; up is opposite to it, and +y without it. A list of shots
// starts with the earliest. Numbers may be up to 1e50 in size, and those marked so must not be negative, or must be
// positive, at least 1e-50; other input throws a std::invalid_argument that names it.
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct Shot {
    Vec2 velocity{0, 0};  ///< when it leaves the muzzle, in the world's frame [m/s]
    double time = 0;      ///< from there to the target [s]
};

/// A point of a trajectory.
struct PathPoint {
    Vec2 position{0, 0};  ///< from the muzzle [m]
    double time = 0;      ///< since the launch [s]
};

}  // namespace plumb
