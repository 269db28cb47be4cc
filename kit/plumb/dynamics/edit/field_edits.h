// SPDX-License-Identifier: MIT
// Which bodies wake when a field is added, changed or removed?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Wakes the bodies on which a field acts. To be called when a field is added, and before and after it changes or
/// before it is removed.
void wakeInfluenced(WorldState& world, const FieldRecord& field);
/// Wakes the bodies that magnets on a body attract. To be called before the body is removed or disabled, and after it
/// has been enabled.
void wakeInfluencedByMagnetsOn(WorldState& world, BodyIndex body);

}  // namespace plumb
