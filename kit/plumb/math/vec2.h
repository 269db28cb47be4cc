// SPDX-License-Identifier: MIT
// Which vectors does the kit compute with?
#pragma once
#include <Eigen/Core>

namespace plumb {

using Vec2 = Eigen::Vector2d;  ///< every public vector, SI units

/// z of a x b: the sine of the turn from a to b, times their lengths.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// v turned a quarter turn counter-clockwise; times an angular speed, the velocity of a point at v.
inline Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}

}  // namespace plumb
