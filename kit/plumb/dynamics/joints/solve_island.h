// SPDX-License-Identifier: MIT
// How are all joints of a machine solved at once?
//
// Joints that hang together through bodies are a island. One pass finds the change of velocity u and the impulses L of
//   M u - J^T L = 0,   J u + e L = r
// M masses, J the rows, r what the rows lack, e a little give that keeps rows apart which say the same; with each row
// on the part of its curve (see joint_rows.h) on which its answer lies, found by turns. No impulse is remembered: a
// chain of a thousand links, or one that carries a thousand times its weight, is solved in one pass, as a pendulum is.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; principal pivoting: Murty 1988.
// Tests: "a chain of 20 links holds a load of a thousand times their mass"
//
// What fills in too much, as a cloth of hinges does, is swept instead, joint by joint, with soft corrections and the
// impulses of the step before as a first guess.
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// What one pass over the joints is told.
struct IslandPass {
    JointPass direct;  ///< for islands that are solved at once
    JointPass swept;
    HingePass hinges;
    const HingeSolver* hingeSolver = nullptr;
    StepObserver* observer = nullptr;  ///< if there is one
};

/// Changes velocities to what the joints ask for, and adds to their loads.
void solveIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const IslandPass& pass);

/// Of an island that is solved at once: takes out what contacts have done to what the joints hold.
void holdIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, JointPass pass, StepObserver* observer);

/// Gives a body of an island that is solved at once an impulse (x, y, turning), and the whole island what follows.
void pushIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse,
                double h);

}  // namespace plumb
