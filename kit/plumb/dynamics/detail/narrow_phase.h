// SPDX-License-Identifier: MIT
// Which shapes touch, or may in the coming step, and where?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Renews the boxes of what is awake, ends and begins contacts, and gives each active one its manifold; wakes what
/// something awake is about to touch.
void findContacts(WorldState& world, double dt);

/// Makes the contacts of two bodies that were kept apart until now, where the space has found their boxes to overlap.
void pairShapes(WorldState& world, BodyIndex a, BodyIndex b);

/// Renews the boxes of one body's shapes for a step of dt.
void placeBody(WorldState& world, BodyIndex body, double dt);

}  // namespace plumb
