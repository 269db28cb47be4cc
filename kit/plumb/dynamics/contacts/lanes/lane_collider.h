// SPDX-License-Identifier: MIT
// Which functions collide and prepare the contacts of a whole batch? The same templates for each number of lanes.
#pragma once
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

struct LaneCollider {
    /// Finds where boxes touch. A box with a rounding radius is treated as a box that is larger by the radius.
    void (*collideBoxes)(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh);
    /// Finds where discs touch discs or boxes. The results in lanes without a disc have no meaning.
    void (*collideDiscs)(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh);
    /// Copies new manifolds into the batch and computes what the solver needs for the step.
    void (*prepare)(ContactBatch& batch, ManifoldLanes& manifolds, const BodyPlace* places,
                    const SolverVelocity* velocity, const FreshLanes& fresh, float inverseStep);
};

template <int W>
struct WideLaneCollider {
    static const LaneCollider code;
};

/// The functions for the largest number of lanes that the machine supports, at most `lanes`.
const LaneCollider& laneCollider(int lanes);

}  // namespace plumb
