// SPDX-License-Identifier: MIT
// How does a block on a slope fall over?
#pragma once
#include <optional>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/worked_motion.h>

namespace plumb::compare {

/// For a block that stands still, with its centre of mass beyond its lower corner: a PendulumMotion about that corner
/// that starts near the top, L = (I + m l^2) / (m l), until its side comes down. Empty if the block does not tip at
/// once.
/// l from the corner to the centre of mass [m]. Source: Landau, Lifshitz, Mechanics, section 11. Throws Unsupported if
/// the corner would slip, or leave the face, on the way.
std::optional<WorkedMotion> tippingMotion(const Scene& scene, const FreeBody& body);

}  // namespace plumb::compare
