// SPDX-License-Identifier: MIT
// What becomes of a body that numbers cannot follow any more?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Takes out the bodies that were marked as out of range: at rest, disabled, and an event for each.
void quarantine(WorldState& world);

}  // namespace plumb
