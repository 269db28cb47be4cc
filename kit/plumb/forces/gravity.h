// SPDX-License-Identifier: MIT
// How large are the force and the potential energy of gravity?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// The same everywhere, as near the ground.
struct UniformGravity {
    Vec2 acceleration{0, -9.81};  ///< g [m/s^2]
};

/// F = m g [N]; m mass [kg], g acceleration [m/s^2]. Source: Newton's second law; Galilei: all bodies fall alike.
/// Throws std::invalid_argument on a mass that is negative or not finite.
Vec2 gravityForce(const UniformGravity& gravity, double mass);

/// U = -m g . r [J], 0 at the origin; r position [m].
/// Test: "the slope of every potential energy is its force, in 100,000 places each"
double potentialEnergy(const UniformGravity& gravity, double mass, const Vec2& position);

/// Gravity between any two masses.
struct MutualGravity {
    double constant = 6.67430e-11;  ///< G, from CODATA 2018; a game uses a larger one [m^3/(kg s^2)]
    double softening = 0;           ///< s: below this distance the force hardly grows, >= 0 [m]
};

struct PointMass {
    double mass = 1;      ///< >= 0 [kg]
    Vec2 position{0, 0};  ///< [m]
};

/// The force on B; A has the opposite one:  F = -G mA mB d / (d^2 + s^2)^(3/2) [N]
/// d from A to B [m], s softening [m]. Two masses at the same position exert no force.
/// Source: Newton, "Principia", 1687, book 3, prop. 7; softening: Aarseth, "Dynamical evolution of clusters of
/// galaxies", MNRAS 126, 1963. Throws std::invalid_argument on a constant, softening or mass that is negative or
/// not finite. Tests: "two masses on a circle are back after one period, whatever the softening", and as above
Vec2 gravityForce(const MutualGravity& gravity, const PointMass& a, const PointMass& b);

/// U = -G mA mB / sqrt(d^2 + s^2) [J], 0 far apart; minus infinity at one place without softening.
double potentialEnergy(const MutualGravity& gravity, const PointMass& a, const PointMass& b);

/// v = d sqrt(G M / (d^2 + s^2)^(3/2)) [m/s], of one relative to the other, on a circle.
/// M the sum of the two masses [kg], > 0; d distance [m], > 0
double circularOrbitSpeed(const MutualGravity& gravity, double totalMass, double distance);

/// T = 2 pi sqrt(a^3 / (G M)) [s]; a semi-major axis of the ellipse, > 0 [m]. Source: Kepler's third law; exact
/// without softening. Test: "an ellipse with e = 0.5 closes after Kepler's period"
double orbitPeriod(const MutualGravity& gravity, double totalMass, double semiMajorAxis);

/// As gravityForce, for input that was checked before.
Vec2 gravityForceOf(const MutualGravity& gravity, const PointMass& a, const PointMass& b);

}  // namespace plumb
