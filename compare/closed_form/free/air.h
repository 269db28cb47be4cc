// SPDX-License-Identifier: MIT
// How does a free body move that the air holds back?
#pragma once
#include <optional>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/worked_motion.h>

namespace plumb::compare {

/// Empty for a body that nothing holds back. By damping, or air that holds it back by its speed, a DampedFlight with
/// k = damping, or linear / m, and g + k wind; by the square of its speed a DragFall with v_t = sqrt(m g / c), from
/// rest in still air. m mass [kg], c quadratic [kg/m]. Source: textbook. Throws Unsupported where it is none of these,
/// or where it may meet something on its way.
std::optional<WorkedMotion> motionInAir(const Scene& scene, const FreeBody& body);

}  // namespace plumb::compare
