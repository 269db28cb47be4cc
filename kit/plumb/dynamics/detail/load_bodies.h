// SPDX-License-Identifier: MIT
// What do the hot loops need to know of each body for this step?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Puts every awake body's state into the floats of narrow phase and solver. Marks those for quarantine whose state is
/// out of the range of sound numbers, and leaves them out.
void loadBodies(WorldState& world, double dt);
/// One body that woke up within the step.
void loadBody(WorldState& world, BodyIndex body, double dt);

}  // namespace plumb
