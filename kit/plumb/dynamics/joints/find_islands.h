// SPDX-License-Identifier: MIT
// Which joints form one joint island, and is it solved at once or swept?
#pragma once
#include <vector>

#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

/// Finds the islands of all joints that act and have an awake body, in the order of their first joints.
void findJointIslands(JointIslands& found, const JointStore& joints, const BodyStore& bodies);

/// Copies the geometric stiffness of each body that was in one of the islands before. slots: number of bodies' records.
void keepStiffness(const std::vector<JointIsland>& before, std::vector<JointIsland>& islands, std::size_t slots);

}  // namespace plumb
