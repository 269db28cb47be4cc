// SPDX-License-Identifier: MIT
// How fast must a body be so that its path is searched for walls?
//
// Bodies are loaded with a limit below which they cannot pass anything (see SolverTurn::farSpeedSquared). Most fast
// bodies are far from all walls: they get the speed at which they could come to one. Beside a wall that moves, even a
// body at rest may be passed by it: its limit is lower by the wall's speed.
#pragma once
#include <plumb/dynamics/jointed/joint_solver.h>
#include <plumb/dynamics/meetings/wall_search.h>

namespace plumb {

struct WallLimitStores {
    BodyStore& bodies;
    const ContactStore& contacts;
    const ContactGraph& graph;
    const JointStore& joints;
    JointSolver& jointSolver;
    const Space& space;
};

/// Changes the limits of the bodies that are awake, for a step of dt [s]; call it after contacts are made.
void limitByWalls(const WallLimitStores& stores, double dt);

}  // namespace plumb
