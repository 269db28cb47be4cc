// SPDX-License-Identifier: MIT
// What do edits of a world have in common? Each is what a room below does, with the stores of a world, and what follows
// from it for the others.
#pragma once
#include <span>

#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// See islands/wake.h and islands/sleep.h.
void wakeIsland(WorldState& world, BodyIndex body);
void wakeNeighbours(WorldState& world, BodyIndex body);
void sleepIsland(WorldState& world, BodyIndex body);

/// Takes a contact out of the world, with an end event if it was touching.
void removeContact(WorldState& world, ContactIndex contact);
/// Lets the solver take a contact in anew, with its impulses, as what it was made from has changed.
void renewContact(WorldState& world, ContactIndex contact);
/// Makes a contact or a sensor pair of two shapes that have come near each other, and wakes what that may move.
void addPair(WorldState& world, const ShiftedShapes& pair);
void addPairs(WorldState& world, std::span<const ShiftedShapes> pairs);

}  // namespace plumb
