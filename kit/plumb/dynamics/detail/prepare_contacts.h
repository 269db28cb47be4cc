// SPDX-License-Identifier: MIT
// What of a contact stays the same through a step?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Fills the batches from the manifolds: anchors, effective masses, start separations, and at what speed to bounce.
void prepareContacts(WorldState& world, double dt);

}  // namespace plumb
