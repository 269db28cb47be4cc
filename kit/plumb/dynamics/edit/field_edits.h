// SPDX-License-Identifier: MIT
// Which bodies wake when a field comes, changes or goes?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Before a field comes, changes or goes.
void wakeInfluenced(WorldState& world, const FieldRecord& field);
/// Before a body that may carry magnets goes, and after one has come.
void wakeInfluencedByMagnetsOn(WorldState& world, BodyIndex body);

}  // namespace plumb
