// SPDX-License-Identifier: MIT
// Which bodies have gone through a wall between two impacts, or after the last one?
//
// Impacts find what a body meets by its contacts. A body that was hit may leave the bounds for which its contacts were
// made, and fly so far that none are made for all that is there. Its path is searched for walls here. Where it meets
// one, the impact is solved, and it flies on from there to the end of the step; what it would have met later in this
// step, it does not.
#pragma once
#include <plumb/dynamics/impacts/flying_bodies.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// Call this when impacts have moved their bodies. Returns the impacts at walls; the trajectories get the new paths.
StepList<WallImpact> stopFlights(ImpactStores& stores, Trajectories& trajectories, double dt);

}  // namespace plumb
