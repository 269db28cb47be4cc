// SPDX-License-Identifier: MIT
// Which vectors do hot loops compute with, relative to a body?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

using Vec2f = Eigen::Vector2f;

// As of a Vec2.
inline float cross(const Vec2f& a, const Vec2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}
inline Vec2f perp(const Vec2f& v) {
    return {-v.y(), v.x()};
}

}  // namespace plumb
