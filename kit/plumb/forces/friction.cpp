// SPDX-License-Identifier: MIT
#include <plumb/forces/friction.h>

#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/check.h>

namespace plumb {
Vec2 frictionForce(const GroundFriction& ground, double mass, const Vec2& velocity) {
    requireNumbers(ground);
    requireNotNegative(mass, "frictionForce: mass");
    const double speed = velocity.norm();
    if (speed == 0) return {0, 0};
    return -(ground.friction * mass * ground.gravity) * (velocity / speed);
}

double frictionTorque(const GroundFriction& ground, double mass, double angularVelocity) {
    requireNumbers(ground);
    requireNotNegative(mass, "frictionTorque: mass");
    const double most = ground.friction * mass * ground.gravity * ground.lever;
    return angularVelocity > 0 ? -most : angularVelocity < 0 ? most : 0;
}

Vec2 velocityAfterFriction(const GroundFriction& ground, const Vec2& velocity, double time) {
    requireNumbers(ground);
    requireNotNegative(time, "velocityAfterFriction: time");
    const double speed = velocity.norm();
    const double loss = ground.friction * ground.gravity * time;
    if (speed <= loss) return {0, 0};
    return (1 - loss / speed) * velocity;
}

double angularVelocityAfterFriction(const GroundFriction& ground, double mass, double inertia, double angularVelocity,
                                    double time) {
    requirePositive(inertia, "angularVelocityAfterFriction: inertia");
    requireNotNegative(time, "angularVelocityAfterFriction: time");
    const double change = frictionTorque(ground, mass, angularVelocity) / inertia * time;
    const double after = angularVelocity + change;
    return after * angularVelocity > 0 ? after : 0;
}

}  // namespace plumb
