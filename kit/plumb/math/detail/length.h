// SPDX-License-Identifier: MIT
// What are the length and the direction of a vector, even if its square underflows or overflows?
#pragma once
#include <algorithm>
#include <cmath>

#include <plumb/math/vec2.h>

namespace plumb::detail {

/// v / |v|, where the square of v is not 0 and finite.
inline Vec2 unit(const Vec2& v) {
    return v / std::sqrt(v.dot(v));
}

/// As Vec2::norm, but accurate to the last place for tiny and for huge vectors as well.
inline double lengthOf(const Vec2& v) {
    const double square = v.squaredNorm();
    if (square > 1e-280 && square < 1e300) return std::sqrt(square);
    const double larger = std::max(std::fabs(v.x()), std::fabs(v.y()));
    if (!(larger > 0)) return 0;
    const double x = v.x() / larger, y = v.y() / larger;
    return larger * std::sqrt(x * x + y * y);
}

/// The unit vector of any finite vector but zero, which stays zero.
inline Vec2 directionOf(const Vec2& v) {
    const double larger = std::max(std::fabs(v.x()), std::fabs(v.y()));
    if (!(larger > 0)) return {0, 0};
    const double x = v.x() / larger, y = v.y() / larger;
    const double length = std::sqrt(x * x + y * y);
    return {x / length, y / length};
}

/// v, or a vector of length most in the same direction.
inline Vec2 limited(const Vec2& v, double most) {
    const double length = lengthOf(v);
    return length > most ? Vec2(most * directionOf(v)) : v;
}

}  // namespace plumb::detail
