// SPDX-License-Identifier: MIT
// What do the hot loops need to know of each body for this step?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Puts every awake body's state into the floats of narrow phase and solver, and renews the boxes of its shapes. Marks
/// those for quarantine whose state is out of the range of sound numbers, and leaves them out.
void loadBodies(WorldState& world, double dt);
/// One body that woke up within the step; its boxes stay. False if it was left out.
bool loadBody(WorldState& world, BodyIndex body, double dt);

}  // namespace plumb
