// SPDX-License-Identifier: MIT
// What is left of a vector within a limit?
#pragma once
#include <plumb/math/detail/length.h>

namespace plumb::detail {

/// v, or what points the same way and is as long as most.
inline Vec2 limited(const Vec2& v, double most) {
    const double length = lengthOf(v);
    return length > most ? Vec2(most * directionOf(v)) : v;
}

}  // namespace plumb::detail
