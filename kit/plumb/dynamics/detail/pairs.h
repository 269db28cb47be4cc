// SPDX-License-Identifier: MIT
// Which shapes have come near each other?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Do joints keep two bodies from touching each other?
bool joinedApart(const WorldState& world, BodyIndex a, BodyIndex b);
/// How far a body comes in this step if nothing is in the way, as its boxes see it [m]. They do not follow what goes
/// round a world that wraps in a single step: it is stopped at walls on its way, and meets bodies where steps begin.
Vec2 foreseenShift(const WorldState& world, BodyIndex body);
/// Renews the boxes of one body's shapes for a step of dt.
void placeBody(WorldState& world, BodyIndex body, double dt);
/// Makes the contacts of two bodies that were kept apart until now, where the space has found their boxes to overlap.
void pairShapes(WorldState& world, BodyIndex a, BodyIndex b);
/// Makes the contacts of a shape that were kept apart until now, likewise.
void pairShape(WorldState& world, ProxyId proxy);
/// Works out what two shapes' materials are together.
void mixMaterials(const WorldState& world, ContactRecord& contact);
/// Makes contacts of the pairs whose boxes have come to overlap.
void findPairs(WorldState& world);

}  // namespace plumb
