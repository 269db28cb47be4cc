// SPDX-License-Identifier: MIT
// How do the bodies and joints of islands get into the solver's lanes, and back?
//
// From the start of a step to its end the lanes hold the bodies in double. Contacts, fields and walls see and change
// the bodies' records, in float. The protocol between the two:
// - After lanes have changed, they are written: a record is the rounded number of its lane.
// - Before lanes are used, they are pulled: what others have changed is the difference between a record and the rounded
//   number, and is added to the number. So a number that nobody else changes is never rounded: pendulums keep their
//   energy to the digits of doubles.
// - A place is taken over instead. It must be the same on the bit, or the body may be behind the wall that stopped it.
#pragma once
#include <plumb/dynamics/joints/island_numbers.h>

namespace plumb {

/// At the start of a step with sub-steps of h [s]: the bodies, joints and rows of islands that are laid out.
void loadIslands(const IslandNumbers& numbers, const JointStore& joints, const BodyStore& bodies, double h);
/// At its end: writes states and loads of the joints, stiffness of the islands and moments of inertia.
void storeIslands(const IslandNumbers& numbers, JointStore& joints, BodyStore& bodies);

void pullVelocities(const IslandNumbers& numbers, const BodyStore& bodies);
void pullPlaces(IslandNumbers& numbers, const BodyStore& bodies);
/// Of active lanes.
void writeVelocities(const IslandNumbers& numbers, BodyStore& bodies);
/// Velocities and places of one island. The others stay as they are: what is added in two parts is rounded otherwise
/// than what is added at once, and bits must not depend on who shares a batch.
void pullMoves(IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane);
void writePlaces(const IslandNumbers& numbers, BodyStore& bodies);

/// How a body has moved in a step, and its velocity at the step's end.
struct BodyMove {
    Vec2 shift{0, 0};     ///< [m]
    double turn = 0;      ///< [rad]
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
};

BodyMove moveOf(const IslandNumbers& numbers, std::size_t node, std::size_t lane);

}  // namespace plumb
