// SPDX-License-Identifier: MIT
// How large may the numbers of a sweep be?
#pragma once
#include <string>

#include <plumb/collide/sweep.h>
#include <plumb/math/check.h>

namespace plumb {

/// A sweep multiplies four of its numbers, as the square of a turn, an arm and a gap. Of larger ones that overflows,
/// and what overflowed would be told as a touch, or as none [m, m/s, rad].
inline constexpr double farthestReach = 1e75;

// Each throws std::invalid_argument with the name, the number and what is wrong.

inline void requireReach(const Vec2& value, const std::string& field, const std::string& member) {
    requireFinite(value, field, member);
    for (const double part : {value.x(), value.y()}) requireWithin(part, -farthestReach, farthestReach, field, member);
}

/// Unless it is finite, and within reach but for its angle.
void requireReach(const Way& way, const std::string& name);

/// Unless it is one that a body can have, and lies within reach.
void requireReach(const Shape& shape, const std::string& name);

}  // namespace plumb
