// SPDX-License-Identifier: MIT
// What happens to a body whose position or velocity leaves the range of numbers?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Puts the bodies that were marked as out of range in quarantine: sets them to rest, disables them, and adds an event
/// for each.
void quarantine(WorldState& world);

}  // namespace plumb
