// SPDX-License-Identifier: MIT
// Who would have gone through a wall in this step, and where should it have stopped?
//
// Contacts are made ahead and mostly stop a body at the wall; this is the net behind them, for what came another way
// than foreseen: deflected, pushed, or spinning. It catches what has gone through something static or kinematic, or so
// deep into it that the way out is on the wrong side, and puts it to where the two met, as seen from the wall. Its
// velocity stays: it arrives in the next step, as an impact like any other.
#pragma once
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/impacts/wall_search.h>

namespace plumb {

/// To be called when all bodies have their new places, and their forces are still known.
void stopAtWalls(BodyStore& bodies, const ContactStore& contacts, const Space& space, const Trajectories& trajectories,
                 double dt);

}  // namespace plumb
