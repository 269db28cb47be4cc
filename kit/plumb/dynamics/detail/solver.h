// SPDX-License-Identifier: MIT
// How are contacts and joints solved together?
//
// Each sub-step h: half of gravity and of the last impulses, solve with the position errors, move, the other half,
// relax without the position errors. In two halves around the move, motion under a steady force or on a joint's circle
// is right to second order in h, where gravity all at once leaves an error of a t h / 2.
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Moves the constrained bodies on by dt. A body that got no impulse is left where it was, for its closed form.
void solveConstraints(WorldState& world, double dt);

}  // namespace plumb
