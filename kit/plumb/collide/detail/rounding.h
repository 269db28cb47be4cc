// SPDX-License-Identifier: MIT
// Which lengths are rounding errors of float arithmetic on coordinates of this size?
#pragma once
#include <cmath>
#include <limits>

#include <plumb/math/vec2.h>

namespace plumb {

inline float manhattan(const Vec2f& v) {
    return std::abs(v.x()) + std::abs(v.y());
}

/// Eight roundings of a number of this size: rotation, translation, difference and product make about six.
inline float roundingOf(float size) {
    return 4 * std::numeric_limits<float>::epsilon() * size;
}

}  // namespace plumb
