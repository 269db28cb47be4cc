// SPDX-License-Identifier: MIT
// How small a length can float arithmetic on such coordinates still tell from nothing?
#pragma once
#include <cmath>
#include <limits>

#include <plumb/math/vec2f.h>

namespace plumb {

inline float manhattan(const Vec2f& v) {
    return std::abs(v.x()) + std::abs(v.y());
}

/// Eight roundings of a number of this size: turn, shift, difference and product make about six.
inline float roundingOf(float size) {
    return 4 * std::numeric_limits<float>::epsilon() * size;
}

}  // namespace plumb
