// SPDX-License-Identifier: MIT
// How large may the numbers of a sweep be?
#pragma once
#include <string>

#include <plumb/math/check.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// A sweep multiplies four of its numbers, such as the square of a turn, an arm and a gap. Larger numbers would
/// overflow, and the result would be a false touch or a false miss [m, m/s, rad].
inline constexpr double maxMagnitude = 1e75;

// Each throws std::invalid_argument with the name, the number and what is wrong.

inline void requireInRange(const Vec2& value, const std::string& field, const std::string& member) {
    requireFinite(value, field, member);
    for (const double part : {value.x(), value.y()}) requireWithin(part, -maxMagnitude, maxMagnitude, field, member);
}

/// Unless it is a shape that a body can have, and lies within maxMagnitude.
inline void requireInRange(const Shape& shape, const std::string& name) {
    validate(shape, name);
    const Aabb box = aabbOf(shape, {});
    requireInRange(box.lower, name, ": box.lower");
    requireInRange(box.upper, name, ": box.upper");
}

}  // namespace plumb
