// SPDX-License-Identifier: MIT
// Where is a point that moves on a circle at constant speed?
#pragma once
#include <plumb/math/check.h>
#include <plumb/math/trig.h>
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
inline CircularPoint circularAt(const CircularMotion& motion, double time) {
    requireFinite(motion.center, "CircularMotion.center");
    requireNotNegative(motion.radius, "CircularMotion.radius");
    requireFinite(motion.startAngle, "CircularMotion.startAngle");
    requireFinite(motion.angularVelocity, "CircularMotion.angularVelocity");
    requireFinite(time, "time");
    const double w = motion.angularVelocity;
    requireFinite(w * time, "CircularMotion.angularVelocity * time");
    requireFinite(motion.startAngle + w * time, "CircularMotion.startAngle + angularVelocity * time");
    requireFinite(w * (w * motion.radius), "CircularMotion.angularVelocity^2 * radius");
    const SinCos angle = sinCos(motion.startAngle + w * time);
    const Vec2 arm(motion.radius * angle.cos, motion.radius * angle.sin);
    return {motion.center + arm, w * perp(arm), -w * (w * arm)};
}

}  // namespace plumb
