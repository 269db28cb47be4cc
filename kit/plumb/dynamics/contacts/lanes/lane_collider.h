// SPDX-License-Identifier: MIT
// Which code finds and prepares the contacts of a whole batch? The same text for each number of lanes.
#pragma once
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

struct LaneCollider {
    /// Where boxes touch, taken with their radii as boxes without.
    void (*collideBoxes)(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh);
    /// Where discs touch; lanes without a disc are filled with anything.
    void (*collideDiscs)(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh);
    /// Takes fresh manifolds into the batch.
    void (*prepare)(ContactBatch& batch, ManifoldLanes& manifolds, const BodyPlace* places,
                    const SolverVelocity* velocity, const FreshLanes& fresh, float inverseStep);
};

template <int W>
struct WideLaneCollider {
    static const LaneCollider code;
};

/// For at most so many lanes, as the machine can.
const LaneCollider& laneCollider(int lanes);

}  // namespace plumb
