// SPDX-License-Identifier: MIT
// Which operations do all edits of a world share? Each calls the function of a folder of lower rank with the stores of
// a world, and then updates the other stores.
#pragma once
#include <span>

#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// See islands/wake.h and islands/sleep.h.
void wakeIsland(WorldState& world, BodyIndex body);
void wakeNeighbours(WorldState& world, BodyIndex body);
void sleepIsland(WorldState& world, BodyIndex body);

/// Removes a contact from the world, with an end event if it was touching.
void removeContact(WorldState& world, ContactIndex contact);
/// Makes the solver prepare a contact again, with its impulses, because its shapes or bodies have changed.
void renewContact(WorldState& world, ContactIndex contact);
/// Makes a contact or a sensor pair of two shapes that have come near each other, and wakes the bodies that this may
/// move.
void addPair(WorldState& world, const ShiftedShapes& pair);
void addPairs(WorldState& world, std::span<const ShiftedShapes> pairs);

/// Wakes the bodies on which a field acts. To be called when a field is added, and before and after it changes or
/// before it is removed.
void wakeInfluenced(WorldState& world, const FieldRecord& field);
/// Wakes the bodies that magnets on a body attract. To be called before the body is removed or disabled, and after it
/// has been enabled.
void wakeInfluencedByMagnetsOn(WorldState& world, BodyIndex body);

}  // namespace plumb
