// SPDX-License-Identifier: MIT
// How does a body move that a joint or a field holds, by the scene's own numbers?
#pragma once
#include <compare/closed_form/worked_motion.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

// Each takes its numbers from the scene, and throws Unsupported, with the body and the reason, where what it names is
// not what it has a formula for. Tests: tests/compare/closed_form/follows_test.cpp

/// A PendulumMotion: L = (I + m l^2) / (m l) on a hinge, L = l on rods; l from the pivot to the centre of mass [m].
/// One after another it holds where all are alike, touch each other as they hang, are smooth, and lose nothing.
WorkedMotion heldMotion(const SwingsMotion& motion, const Scene& scene);

/// An OscillatorMotion with k and c of the spring, about where it holds the weight: its length + m g / k.
WorkedMotion heldMotion(const SpringsMotion& motion, const Scene& scene);

/// An OscillatorMotion with k = rho g b, about where it floats; of an upright box of width b [m] that neither leaves
/// the water nor dives. rho the water's density [kg/m^2], g its gravity [m/s^2]
WorkedMotion heldMotion(const FloatsMotion& motion, const Scene& scene);

/// A KeplerMotion: of r'' = -K r / r^3 with K = G (m1 + m2), or S (1/m1 + 1/m2) of a magnet; a = -K / (2 E), e from
/// v x h / K - r / r, T^2 = 4 pi^2 a^3 / K. Until they touch, where they may.
WorkedMotion heldMotion(const OrbitsMotion& motion, const Scene& scene);

/// A flight at the acceleration of Atwood's machine, until an end is up at its wheel.
WorkedMotion heldMotion(const HoistedMotion& motion, const Scene& scene);

/// A flight at r M / sum(I_i r_i^2), until the motor is at its speed. M the motor's torque or force, r_i how far part i
/// goes for each radian or metre of the motor's, I_i its inertia or mass. Source: virtual work.
WorkedMotion heldMotion(const GearedMotion& motion, const Scene& scene);

/// A PendulumMotion from the impact on, at which momentum is kept: see ballistic_pendulum.h.
WorkedMotion heldMotion(const CaughtMotion& motion, const Scene& scene);

/// A flight that goes nowhere. Holds where there are forces in the scene's joints that balance gravity on each body
/// that they hold, which is checked by least squares; what else may touch it is taken to be at rest beside it.
WorkedMotion heldMotion(const RestsMotion& motion, const Scene& scene);

}  // namespace plumb::compare
