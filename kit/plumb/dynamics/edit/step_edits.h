// SPDX-License-Identifier: MIT
// Which edits does a step itself make? Besides breaking joints: it adds the pairs of shapes that have come near each
// other, and takes out bodies whose position or velocity leaves the range of numbers.
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Finds the pairs of shapes whose bounds overlap since the last step, and adds a contact or a sensor pair for each. In
/// a crowd some are left out for later (see contacts/crowd.h); those that an edit or an impact has added are known.
void addNewPairs(WorldState& world);

/// Puts the bodies that were marked as out of range in quarantine: sets them to rest, disables them, and adds an event
/// for each.
void quarantine(WorldState& world);

}  // namespace plumb
