// SPDX-License-Identifier: MIT
// Which vector types does the kit use?
#pragma once
#include <Eigen/Core>

namespace plumb {

using Vec2 = Eigen::Vector2d;   ///< for every public vector, in SI units
using Vec2f = Eigen::Vector2f;  ///< in hot loops, for coordinates relative to a body

/// z component of a x b: |a| |b| times the sine of the angle from a to b.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// v rotated by 90 degrees counter-clockwise; times an angular velocity, the velocity of a point at v.
inline Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}

// The same in float.
inline float cross(const Vec2f& a, const Vec2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}
inline Vec2f perp(const Vec2f& v) {
    return {-v.y(), v.x()};
}

}  // namespace plumb
