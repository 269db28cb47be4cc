// SPDX-License-Identifier: MIT
// Where is a point that moves on a circle at constant speed?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct CircularMotion {
    Vec2 center{0, 0};           ///< [m]
    double radius = 1;           ///< >= 0 [m]
    double startAngle = 0;       ///< at time 0, from +x [rad]
    double angularVelocity = 1;  ///< [rad/s]
};

struct CircularPoint {
    Vec2 position;      ///< [m]
    Vec2 velocity;      ///< along the circle, of size r |w| [m/s]
    Vec2 acceleration;  ///< centripetal: towards the center, of size r w^2 [m/s^2]
};

/// p = c + r (cos A, sin A),  v = w perp(p - c),  a = -w^2 (p - c),  A = A0 + w t
/// p position, c center, r radius [m], A angle, A0 startAngle [rad], w angularVelocity [rad/s], t time [s].
/// Source: textbook. Exact to the rounding of w t. For a wheel with constant angular acceleration use solveMotion with
/// angles.
/// Throws std::invalid_argument on a negative radius and on what is not finite, A and w^2 r included.
/// Test: "the velocity and the acceleration on a circle are the slopes of the place and of the velocity"
CircularPoint circularAt(const CircularMotion& motion, double time);

}  // namespace plumb
