// SPDX-License-Identifier: MIT
// How does a body move that is held by a joint or a field, by the scene's own numbers?
#pragma once
#include <compare/closed_form/motion.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

// Each function takes its numbers from the scene. It throws Unsupported, with the body and the reason, if it has no
// formula for the things that the motion names. Tests: tests/compare/closed_form/follows_test.cpp

/// A PendulumMotion: L = (I + m l^2) / (m l) on a hinge, L = l on rods; l from the pivot to the centre of mass [m].
/// For a row of pendulums that swing one after another, all must be equal, touch each other when they hang, be smooth,
/// and lose no energy.
WorkedMotion heldMotion(const SwingsMotion& motion, const Scene& scene);

/// An OscillatorMotion with k and c of the spring, about the place where the spring carries the weight:
/// its length + m g / k.
WorkedMotion heldMotion(const SpringsMotion& motion, const Scene& scene);

/// An OscillatorMotion with k = rho g b, about the place where it floats; for an upright box of width b [m] that
/// neither leaves the water nor dives. rho is the water's density [kg/m^2], g its gravity [m/s^2].
WorkedMotion heldMotion(const FloatsMotion& motion, const Scene& scene);

/// A KeplerMotion: of r'' = -K r / r^3 with K = G (m1 + m2), or S (1/m1 + 1/m2) of a magnet; a = -K / (2 E), e from
/// v x h / K - r / r, T^2 = 4 pi^2 a^3 / K. It holds until they touch, if they can touch.
WorkedMotion heldMotion(const OrbitsMotion& motion, const Scene& scene);

/// A flight at the acceleration of Atwood's machine, until one end has reached its wheel.
WorkedMotion heldMotion(const HoistedMotion& motion, const Scene& scene);

/// A flight at r M / sum(I_i r_i^2), until the motor has reached its speed. M is the motor's torque or force, r_i how
/// far part i moves for each radian or metre of the motor, I_i its inertia or mass. Source: virtual work.
WorkedMotion heldMotion(const GearedMotion& motion, const Scene& scene);

/// A PendulumMotion from the impact on; the impact keeps momentum: see formula/pendulum.h.
WorkedMotion heldMotion(const CaughtMotion& motion, const Scene& scene);

/// A flight that stays at one place. It holds if forces in the scene's joints can balance gravity on each body that
/// they hold, which is checked by least squares. Other bodies that may touch it are assumed to be at rest beside it.
WorkedMotion heldMotion(const RestsMotion& motion, const Scene& scene);

}  // namespace plumb::compare
