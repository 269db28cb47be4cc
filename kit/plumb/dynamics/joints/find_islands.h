// SPDX-License-Identifier: MIT
// Which joints form one joint island, and is it solved directly or swept?
#pragma once
#include <vector>

#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The islands of all joints that act and have an awake body, in the order of their first joints. atOnce: an island
/// with more joints than this is swept instead of solved directly.
std::vector<JointIsland> findJointIslands(const JointStore& joints, const BodyStore& bodies, int atOnce,
                                          BlockPlans& plans);

/// Copies the geometric stiffness of each body that was in one of the islands before.
void keepStiffness(const std::vector<JointIsland>& before, std::vector<JointIsland>& islands);

}  // namespace plumb
