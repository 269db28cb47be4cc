// SPDX-License-Identifier: MIT
// How long is a vector, and which way does it point, also when its square is too small or too large to be a number?
#pragma once
#include <algorithm>
#include <cmath>

#include <plumb/math/vec2.h>

namespace plumb::detail {

/// v / |v|, where its square is a number other than 0.
inline Vec2 unit(const Vec2& v) {
    return v / std::sqrt(v.dot(v));
}

/// As Vec2::norm, to the last place for tiny and for huge vectors as well.
inline double lengthOf(const Vec2& v) {
    const double square = v.squaredNorm();
    if (square > 1e-280 && square < 1e300) return std::sqrt(square);
    const double larger = std::max(std::fabs(v.x()), std::fabs(v.y()));
    if (!(larger > 0)) return 0;
    const double x = v.x() / larger, y = v.y() / larger;
    return larger * std::sqrt(x * x + y * y);
}

/// Of length 1, for any finite vector but zero, which stays zero.
inline Vec2 directionOf(const Vec2& v) {
    const double larger = std::max(std::fabs(v.x()), std::fabs(v.y()));
    if (!(larger > 0)) return {0, 0};
    const double x = v.x() / larger, y = v.y() / larger;
    const double length = std::sqrt(x * x + y * y);
    return {x / length, y / length};
}

}  // namespace plumb::detail
