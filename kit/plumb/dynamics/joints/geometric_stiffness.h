// SPDX-License-Identifier: MIT
// How fast would a tight chain or rod swing sideways, and how is that kept slow enough for the sub-step?
//
// Under a tension F, a link is turned back with the stiffness k = F.r [N m/rad] for each anchor r, and a rod of length
// l pulls its ends back with the stiffness F/l [N/m]. Where this oscillation would be too fast for the sub-step h, the
// body gets more inertia, until I + I' >= 2 h^2 k and m >= h^2 k. I' is the inertia that its neighbours add, because
// they must move when the body turns. Source: Andrews, Teichmann, Kry, "Geometric stiffness for real-time constrained
// multibody dynamics", Comput. Graph. Forum 36 (2017) 235, where it is a separate term.
// Test: "a bridge of 30 planks between two banks bears a heavy box at its middle"
#pragma once
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// Finds the mass and moment of inertia of each body for the sub-step h [s]. Along x and y the mass is at least the
/// mass that the body's stiffness needs.
void findMasses(JointIsland& island, const BodyStore& bodies, double h);
/// Finds the stiffness from the impulses of the last pass, over half a sub-step. From the next step on, contacts use
/// the same increased moment of inertia as the joints do: otherwise contacts would add energy.
void noteStiffness(JointIsland& island, BodyStore& bodies, double h);

}  // namespace plumb
