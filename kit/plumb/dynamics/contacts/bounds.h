// SPDX-License-Identifier: MIT
// Which box must the space have of a shape, so that all that it may meet in a step is found?
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/space/space.h>

namespace plumb {

/// How far a body comes in this step if nothing is in the way, as its bounds have it [m]. They do not follow what goes
/// round a world that wraps in a single step: it is stopped at walls on its way, and meets bodies where steps begin.
Vec2 predictedShift(const BodyStore& bodies, BodyIndex body);
/// Renews the bounds of one body's shapes for a step of dt [s].
void placeBounds(Space& space, const BodyStore& bodies, const ContactStore& contacts, BodyIndex body, double dt);
/// The same for all bodies that are awake and in range.
void placeAwakeBounds(Space& space, BodyStore& bodies, const ContactStore& contacts, double dt);
/// Has a shape of the body been moved out of its bounds?
bool hasLeftItsBounds(const Space& space, const BodyStore& bodies, BodyIndex body);

}  // namespace plumb
