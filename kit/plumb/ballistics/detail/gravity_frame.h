// SPDX-License-Identifier: MIT
// Which direction is up, and which is horizontal, for a given gravity?
#pragma once
#include <plumb/ballistics/shot.h>
#include <plumb/math/detail/length.h>

namespace plumb::detail {

/// A target at this distance or less is at the muzzle: its time of flight could not be distinguished from 0.
inline constexpr double muzzle = 1e-200;

/// Axes along and across gravity; without gravity, up is +y.
struct GravityFrame {
    double gravity = 0;  ///< [m/s^2]
    Vec2 up{0, 1}, right{1, 0};

    explicit GravityFrame(const Vec2& gravityVector) : gravity(lengthOf(gravityVector)) {
        if (!(gravity > 0)) return;
        up = -directionOf(gravityVector);
        right = {up.y(), -up.x()};
    }
};

/// The same direction, with the requested length: removes rounding errors of the length.
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
