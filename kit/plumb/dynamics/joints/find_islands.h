// SPDX-License-Identifier: MIT
// Which joints form one joint island, and is it solved at once or swept?
#pragma once
#include <vector>

#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

/// Finds the islands of all joints that act and have an awake body, in the order of their first joints. Those whose
/// joints and bodies were not edited keep their layouts.
void findJointIslands(JointIslands& found, JointStore& joints, const BodyStore& bodies);

}  // namespace plumb
