// SPDX-License-Identifier: MIT
// Which vectors does the kit compute with?
#pragma once
#include <Eigen/Core>

namespace plumb {

using Vec2 = Eigen::Vector2d;   ///< every public vector, SI units
using Vec2f = Eigen::Vector2f;  ///< hot loops only, relative to a body

/// z of a x b: the sine of the turn from a to b, times their lengths.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}
inline float cross(const Vec2f& a, const Vec2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// v turned a quarter turn counter-clockwise; times an angular speed, the velocity of a point at v.
inline Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}
inline Vec2f perp(const Vec2f& v) {
    return {-v.y(), v.x()};
}

}  // namespace plumb
