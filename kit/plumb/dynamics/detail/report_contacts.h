// SPDX-License-Identifier: MIT
// Which shapes began to touch in this step, and which ceased?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Two shapes touch when they press on each other or overlap, until they are a millimetre apart.
void reportContacts(WorldState& world);

}  // namespace plumb
