// SPDX-License-Identifier: MIT
// Where do shapes touch that are near each other, and what does the solver need to know of it?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Makes all manifolds anew: of contacts in the solver's slots batch by batch, where they are prepared for the step,
/// and of the others near each other. What comes to touch gets a slot, what has parted loses it, and sleepers that are
/// touched wake up.
void findContacts(WorldState& world, double dt);

/// Can anything come of it in this step? Not with a sleeper: what might touch one has woken it.
bool bodiesReady(const WorldState& world, const ContactRecord& contact);

}  // namespace plumb
