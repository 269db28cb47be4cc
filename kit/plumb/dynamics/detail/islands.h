// SPDX-License-Identifier: MIT
// Which bodies hang together, and may they sleep?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Wakes a body and all that it touches or is joined to, and so on. Does nothing to what cannot move.
void wakeIsland(WorldState& world, BodyIndex body);
/// Wakes whatever touches a body or is joined to it, before it changes or goes.
void wakeNeighbours(WorldState& world, BodyIndex body);
/// Puts a body to sleep with all that touches it or is joined to it, and so on; not what something moves that is awake.
void sleepIsland(WorldState& world, BodyIndex body);
/// Counts how long each body has been still, and puts to sleep the islands in which all have been for long enough.
void sleepIslands(WorldState& world, double dt);

}  // namespace plumb
