// SPDX-License-Identifier: MIT
// Which bodies wake up together with a body?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Wakes a body and its whole island: all bodies connected with it by contacts and joints. Does nothing if the body
/// cannot move.
void wakeIsland(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);
/// The same for the bodies that a phase of the step has returned, in their order. During a step, only this function
/// wakes bodies.
void wakeIslands(BodyStore& bodies, ContactStore& contacts, JointStore& joints, std::span<const BodyIndex> named);
/// Wakes all bodies that touch a body or are joined to it. Call this before the body changes or is removed.
void wakeNeighbours(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body);

}  // namespace plumb
