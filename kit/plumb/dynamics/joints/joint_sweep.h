// SPDX-License-Identifier: MIT
// How is one joint of a island solved that is too closely knit to be solved at once?
#pragma once
#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Its impulse of the half before is a first guess; then the rows that are driven or limited, one by one; then those
/// that hold, together.
void sweepJoint(JointRecord& record, JointLoad& load, const JointRows& rows, BodyStore& bodies, const Softness& soft);

}  // namespace plumb
