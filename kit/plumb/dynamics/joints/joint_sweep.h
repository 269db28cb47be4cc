// SPDX-License-Identifier: MIT
// How is one joint solved in an island with too many loops for a direct solution?
#pragma once
#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Applies the impulse of the previous half sub-step as a first guess. Then solves the driven and limited rows one by
/// one, and after them all rows that hold together.
void sweepJoint(JointRecord& record, JointLoad& load, const JointRows& rows, BodyStore& bodies, const Softness& soft);

}  // namespace plumb
