// SPDX-License-Identifier: MIT
// How fast would a tight line swing sideways, and what keeps that to what a sub-step can follow?
//
// At its tension F a link turns back at k = F.r [N m/rad] for each anchor r, a rod of length l swings its ends back at
// F/l [N/m]. What that would make faster than the sub-step h can follow is given more inertia in here, until
// I + I' >= 2 h^2 k, and m >= h^2 k, so that it swings as slowly as it can be followed; I' is what its neighbours must
// be moved by for it to turn. Source: Andrews, Teichmann, Kry, "Geometric stiffness for real-time constrained
// multibody dynamics", Comput. Graph. Forum 36 (2017) 235, there as a term of its own.
// Test: "a bridge of 30 planks between two banks bears a heavy box at its middle"
#pragma once
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// Of each body, as the step h [s] has them: what swings along x and y weighs no less than its stiffness needs.
void findMasses(JointIsland& island, const BodyStore& bodies, double h);
/// By the impulses of the pass that has just been over half a sub-step. From the next step on, all the world sees a
/// body as heavy to turn as its joints do: else contacts would feed it.
void noteStiffness(JointIsland& island, BodyStore& bodies, double h);

}  // namespace plumb
