// SPDX-License-Identifier: MIT
// How does a free body move against the drag of air?
#pragma once
#include <optional>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/worked_motion.h>

namespace plumb::compare {

/// Empty for a body without drag. For damping, or drag proportional to the speed, a DampedFlight with k = damping, or
/// linear / m, and g + k wind. For drag with the square of the speed, a DragFall with v_t = sqrt(m g / c), from rest in
/// still air. m mass [kg], c quadratic [kg/m]. Source: textbook. Throws Unsupported for all other cases, or if the body
/// may meet something on its way.
std::optional<WorkedMotion> motionInAir(const Scene& scene, const FreeBody& body);

}  // namespace plumb::compare
