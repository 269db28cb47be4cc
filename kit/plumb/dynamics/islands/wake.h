// SPDX-License-Identifier: MIT
// Which bodies wake up together with a body?
//
// To see what wakes a body, stop at BodyStore::wake; to see what keeps one awake, at wakeIsland.
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Wakes a body and its whole island: all bodies connected with it by contacts and joints. Does nothing if the body
/// cannot move.
void wakeIsland(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);
/// The same for the bodies that a phase of the step has returned, in their order.
void wakeIslands(BodyStore& bodies, ContactStore& contacts, JointStore& joints, std::span<const BodyIndex> named);
/// Wakes all bodies that touch a body or are joined to it. Call this before the body changes or is removed.
void wakeNeighbours(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);

}  // namespace plumb
