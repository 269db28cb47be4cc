// SPDX-License-Identifier: MIT
// Which bodies wake when one does?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Wakes a body and all that it touches or is joined to, and so on. Does nothing to what cannot move.
void wakeIsland(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);
/// The same for the bodies that a phase of the step has named, in their order. Here alone a step wakes bodies.
void wakeIslands(BodyStore& bodies, ContactStore& contacts, JointStore& joints, std::span<const BodyIndex> named);
/// Wakes whatever touches a body or is joined to it, before it changes or goes.
void wakeNeighbours(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);

}  // namespace plumb
