// SPDX-License-Identifier: MIT
// How is the length of a vector limited?
#pragma once
#include <plumb/math/detail/length.h>

namespace plumb::detail {

/// v, or a vector of length most in the same direction.
inline Vec2 limited(const Vec2& v, double most) {
    const double length = lengthOf(v);
    return length > most ? Vec2(most * directionOf(v)) : v;
}

}  // namespace plumb::detail
