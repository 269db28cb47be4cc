// SPDX-License-Identifier: MIT
// Is a body still where numbers can follow it, and what if not?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Finite, and below 1e15 m and m/s, so that squares still fit the solver's floats.
bool isSound(const BodyMotion& motion);

/// Marks the bodies that are about to leave the range, by their speed or by the forces on them.
void markUnsound(WorldState& world);

/// Takes the marked bodies out: at rest, without shapes, and an event for each.
void quarantine(WorldState& world);

}  // namespace plumb
