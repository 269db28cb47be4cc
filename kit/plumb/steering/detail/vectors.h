// SPDX-License-Identifier: MIT
// What is a vector's direction, and what is left of it within a limit?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb::detail {

/// Of length 1; zero for a vector too short or too long for its square.
inline Vec2 directionOf(const Vec2& v) {
    const double length = v.norm();
    return length > 0 ? Vec2(v / length) : Vec2(0, 0);
}

/// v, or what points the same way and is as long as most.
inline Vec2 limited(const Vec2& v, double most) {
    const double length = v.norm();
    return length > most ? Vec2(v * (most / length)) : v;
}

}  // namespace plumb::detail
