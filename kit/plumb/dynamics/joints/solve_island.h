// SPDX-License-Identifier: MIT
// How are all joints of an island solved at once?
//
// Joints that are connected through bodies form an island. One pass solves for velocity changes u and impulses L:
//   M u - J^T L = 0,   J u + e L = r
// M masses, J the rows, r the rows' missing change of speed, e a small compliance that keeps the system solvable when
// rows are redundant. Each row is on the part of its curve (see joint_rows.h) that contains its solution; the parts are
// found by iteration. No impulse is kept from pass to pass: a chain of a thousand links, or one that carries a thousand
// times its weight, is solved in one pass, as a pendulum is.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; principal pivoting: Murty 1988.
// Tests: "a chain of 20 links holds a load of a thousand times their mass"
//
// An island whose matrix gets too many new blocks, such as a cloth of hinges, is swept instead: joint by joint, with
// soft corrections and the previous impulses as a first guess.
#pragma once
#include <span>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

/// The inputs of one pass over the joints.
struct IslandPass {
    JointPass direct;  ///< for islands that are solved at once
    JointPass swept;
    HingePass hinges;
    const HingeSolver* hingeSolver = nullptr;
    StepObserver* observer = nullptr;  ///< may be null
};

/// Changes the velocities so that they fulfil the joints' rows, and adds the impulses to the joints' loads.
void solveIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const IslandPass& pass);

// For an island that is solved together with its contacts (see solver/machine_contacts.h):
/// Finds velocities that fulfil the joints' rows, from velocities without the joints' impulses. The rows are predicted
/// from the bodies' present velocities. Returns true if a row came to another part of its curve.
bool tryIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const std::vector<Vec3>& before,
               const JointPass& pass);
/// Adds the impulses of the last try to the joints' loads.
void acceptIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, double h, StepObserver* observer);
/// Adds to changes of velocity, of all bodies of the island, those by the joint impulses that follow from them.
void followJoints(const JointIsland& island, std::span<Vec3> changes);

/// For an island that is solved directly: removes the errors that contacts have caused in the joints' held rows.
void holdIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, JointPass pass, StepObserver* observer);

/// For an island that is solved directly: applies an impulse (x, y, turning) to one body, and the joint impulses that
/// follow from it to the whole island.
void pushIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse,
                double h);
/// By how much that would change the body's velocity.
Vec3 answerOfIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse,
                    double h);

}  // namespace plumb
