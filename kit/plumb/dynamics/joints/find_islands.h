// SPDX-License-Identifier: MIT
// Which joints are in one island, and how is it to be solved?
#pragma once
#include <vector>

#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The islands of the joints that act and have a body awake, in the order of their first joints.
/// atOnce: those of more joints are swept.
std::vector<JointIsland> findJointIslands(const JointStore& joints, const BodyStore& bodies, int atOnce);

/// Bodies that were in an island before keep their stiffness.
void keepStiffness(const std::vector<JointIsland>& before, std::vector<JointIsland>& islands);

}  // namespace plumb
