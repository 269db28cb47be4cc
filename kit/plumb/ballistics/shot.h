// SPDX-License-Identifier: MIT
// What does an answer to "how to aim" hold?
// In this module the muzzle is at the origin and all else relative to it; a target within 1e-200 m is at the
// muzzle. Gravity is a vector, of any direction and down to none; up is against it, and +y without it. Where a
// list of shots is the answer, the earliest stands first. Numbers may be up to 1e50 in size, and those marked so
// must not be negative, or must be positive, 1e-50 at least; what is not so is refused with a
// std::invalid_argument that names it.
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct Shot {
    Vec2 velocity{0, 0};  ///< on leaving the muzzle, as seen by the world [m/s]
    double time = 0;      ///< from there to the target [s]
};

/// A point of a path.
struct PathPoint {
    Vec2 position{0, 0};  ///< from the muzzle [m]
    double time = 0;      ///< since the launch [s]
};

}  // namespace plumb
