// SPDX-License-Identifier: MIT
// Which contacts are isolated impacts, and which are for the solver?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Flies the bodies whose contacts of this step are all isolated impacts, and takes those contacts out of the solver's
/// slots. All others stay there.
void sortOutContacts(WorldState& world, double dt);

}  // namespace plumb
