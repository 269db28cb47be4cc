// SPDX-License-Identifier: MIT
// Which contacts are isolated impacts, and which are for the solver?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Flies the bodies whose contacts of this step are all isolated impacts, and gives the solver's graph the rest:
/// contacts that have come get a slot, contacts that have gone lose theirs. Marks every body the solver is to have.
void sortOutContacts(WorldState& world, double dt);

}  // namespace plumb
