// SPDX-License-Identifier: MIT
// Which shapes began to touch in this step, and which ceased?
#pragma once
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// As a hit, if it is fast enough to be one.
inline ContactHit hitOf(const ContactBegin& begin) {
    return {begin.shapeA, begin.shapeB, begin.point, begin.normal, begin.approachSpeed, begin.tile};
}

/// Two shapes touch when they press on each other or overlap, until they are a millimetre apart.
void reportContacts(WorldState& world);

}  // namespace plumb
