// SPDX-License-Identifier: MIT
// How does friction stop an object that slides on the ground, seen from above?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// Dry friction on the whole base of an object, for top-down games. Sliding and turning are braked independently: an
/// object that does both is braked more than in reality.
struct GroundFriction {
    double friction = 0.5;  ///< mu, Coulomb coefficient, >= 0 [-]
    double gravity = 9.81;  ///< g, into the ground, >= 0 [m/s^2]
    double lever = 0;       ///< l, lever arm of friction against turning; 2/3 of the radius for a full disc, >= 0 [m]
};

/// F = -mu m g v / |v| [N]; 0 at rest. m mass [kg], v velocity [m/s]. Source: Coulomb, 1785.
/// Throws std::invalid_argument on a number of the law, or a mass, that is negative or not finite.
Vec2 frictionForce(const GroundFriction& ground, double mass, const Vec2& velocity);

/// -mu m g l [N m], against the rotation; 0 at rest. For a disc of radius R with uniform pressure, l is the mean
/// distance of its points from its centre, 2 R / 3.
double frictionTorque(const GroundFriction& ground, double mass, double angularVelocity);

/// The velocity after friction alone for a time t >= 0 [s], exactly: |v| falls by mu g t, and not below 0.
/// Test: "a puck at 5 m/s on friction 0.25 slides 5.0968399592 m, and stays"
Vec2 velocityAfterFriction(const GroundFriction& ground, const Vec2& velocity, double time);

/// |w| falls by mu m g l t / I, and not below 0; w angular velocity [rad/s], I inertia > 0 [kg m^2].
double angularVelocityAfterFriction(const GroundFriction& ground, double mass, double inertia, double angularVelocity,
                                    double time);

}  // namespace plumb
