// SPDX-License-Identifier: MIT
// Which bodies would have gone through a wall in this step, and where should they have stopped?
//
// Contacts are predicted, and in most cases they stop a body at the wall. This second test is for bodies whose motion
// differs from the prediction because they were deflected, pushed or spun. It finds bodies that have gone through
// something static or kinematic, or so deep into it that the way out is on the wrong side, and moves each back to the
// place, in the wall's frame, where the two met. The velocity is not changed: the body hits the wall in the next step,
// as an ordinary impact.
#pragma once
#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/impacts/wall_search.h>

namespace plumb {

/// Call this when all bodies have their new places, and before forces are cleared.
void stopAtWalls(BodyStore& bodies, const ContactStore& contacts, const Space& space, const Trajectories& trajectories,
                 double dt);

}  // namespace plumb
