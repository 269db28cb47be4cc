// SPDX-License-Identifier: MIT
// Which way is up, and what does gravity make of the plane?
#pragma once
#include <plumb/ballistics/shot.h>
#include <plumb/math/detail/length.h>

namespace plumb::detail {

/// A target no further away is at the muzzle: times to it could not be told from 0.
inline constexpr double muzzle = 1e-200;

/// What gravity makes of the plane; without it, up is +y.
struct Level {
    double gravity = 0;  ///< [m/s^2]
    Vec2 up{0, 1}, right{1, 0};

    explicit Level(const Vec2& gravityVector) : gravity(lengthOf(gravityVector)) {
        if (!(gravity > 0)) return;
        up = -directionOf(gravityVector);
        right = {up.y(), -up.x()};
    }
};

/// The same direction, of the length that was asked for: what rounding or a close call took is given back.
inline Vec2 withLength(const Vec2& v, double length) {
    return length * directionOf(v);
}

/// (|g| D - g . d), the square of the least speed to a target, without loss of digits below the muzzle.
inline double leastSpeedSquared(const Vec2& target, double distance, const Vec2& gravity, double size) {
    const double along = gravity.dot(target);
    const double both = size * distance;
    if (along <= 0) return both - along;
    const double across = cross(gravity, target);
    return both > 0 ? across * (across / (both + along)) : 0;
}

}  // namespace plumb::detail
