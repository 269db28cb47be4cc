// SPDX-License-Identifier: MIT
// Is a body still where numbers can follow it, and what if not?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Finite, and below 1e15 m and m/s, so that squares still fit the solver's floats.
bool isSound(const BodyMotion& motion);
bool isSound(const Acceleration& acceleration);

/// Marks a body, to be taken out by the next quarantine().
void quarantineLater(WorldState& world, BodyIndex body);

/// Takes the marked bodies out: at rest, disabled, and an event for each.
void quarantine(WorldState& world);

}  // namespace plumb
