// SPDX-License-Identifier: MIT
// How is an island with too many loops for a direct solution solved? Joint by joint, with soft corrections and the
// previous impulses as a first guess.
#pragma once
#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

/// The inputs of one pass over swept islands.
struct SweepPass {
    JointPass joints;
    HingePass hinges;
    const HingeSolver* hingeSolver = nullptr;
    StepObserver* observer = nullptr;  ///< may be null
};

/// Changes the velocities towards those that the joints want, and adds the impulses to the joints' loads.
void sweepIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const SweepPass& pass);

}  // namespace plumb
