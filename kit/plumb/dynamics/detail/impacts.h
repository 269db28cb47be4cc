// SPDX-License-Identifier: MIT
// What happens when bodies in free flight hit each other, or a wall, one pair at a time?
//
// Each body flies on its closed form; the earliest time at which a pair meets is found on those, the two are moved
// there and parted by the closed form of impact, and the search goes on with the rest of the step: as the textbook
// does it, in double precision.
#pragma once
#include <span>

#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Is a contact one that, if it comes to an impact in this step, is over before the step is? Its shapes bounce, and
/// the flight after the bounce takes longer than the step: 2 e v >= a dt.
/// e restitution [-], v approach speed at the impact [m/s], a acceleration that presses the two together [m/s^2]
bool bouncesClear(const WorldState& world, const ContactRecord& contact, double dt);

/// Flies the bodies of these contacts, and of no others, through the step. False, and nothing done, when there were so
/// many impacts that it is rather a heap than a flight.
bool flyThroughImpacts(WorldState& world, std::span<const ContactIndex> contacts, double dt);

}  // namespace plumb
