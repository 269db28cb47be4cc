// SPDX-License-Identifier: MIT
// Which free bodies have one formula for their whole way?
#pragma once
#include <optional>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/motion.h>

namespace plumb::compare {

/// Empty for a body without drag. For damping, or drag proportional to the speed, a DampedFlight with k = damping, or
/// linear / m, and g + k wind. For drag with the square of the speed, a DragFall with v_t = sqrt(m g / c), from rest in
/// still air. m mass [kg], c quadratic [kg/m]. Source: textbook. Throws Unsupported for all other cases, or if the body
/// may meet something on its way.
std::optional<WorkedMotion> motionInAir(const Scene& scene, const FreeBody& body);

/// For a block that stands still, with its centre of mass beyond its lower corner: a PendulumMotion about that corner
/// that starts near the top, L = (I + m l^2) / (m l), until its side comes down. Empty if the block does not tip at
/// once.
/// l from the corner to the centre of mass [m]. Source: Landau, Lifshitz, Mechanics, section 11. Throws Unsupported if
/// the corner would slip, or leave the face, on the way.
std::optional<WorkedMotion> tippingMotion(const Scene& scene, const FreeBody& body);

}  // namespace plumb::compare
