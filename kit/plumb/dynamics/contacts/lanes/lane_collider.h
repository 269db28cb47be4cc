// SPDX-License-Identifier: MIT
// Which functions collide and prepare the contacts of a whole batch? The same templates for each number of lanes.
#pragma once
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/lanes/corner_rows.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

/// Each function computes the first `used` lanes of a batch, and perhaps more.
struct LaneCollider {
    /// Finds where boxes touch. A box with a rounding radius is treated as a box that is larger by the radius.
    void (*collideBoxes)(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh, std::size_t used);
    /// Finds where discs touch discs, boxes or polygons. Lanes without a disc stay as they are.
    void (*collideDiscs)(const PairLanes& pairs, const BodyPlace* places, const CornerTable& corners, FreshLanes& fresh,
                         std::size_t used);
    /// Finds where polygons touch, in the lanes for which wanted is not 0.
    void (*collidePolygons)(const PairLanes& pairs, const BodyPlace* places, const CornerTable& corners,
                            const std::int32_t* wanted, FreshLanes& fresh, std::size_t used);
    /// Uses the manifolds of the last step again; again: not 0 where they are not right any more. now: the places of
    /// this step.
    void (*reuse)(const PairLanes& pairs, const BodyPlace* places, const ManifoldLanes& manifolds,
                  const KeptLanes& kept, FreshLanes& fresh, PoseLanes& now, std::int32_t* again, std::size_t used);
    /// Copies new manifolds into the batch and computes what the solver needs for the step.
    void (*prepare)(ContactBatch& batch, ManifoldLanes& manifolds, const BodyPlace* places,
                    const SolverVelocity* velocity, const FreshLanes& fresh, const StepLength& step, std::size_t used);
};

template <int W>
struct WideLaneCollider {
    static const LaneCollider code;
};

/// The functions for the largest number of lanes that the machine supports, at most `lanes`.
const LaneCollider& laneCollider(int lanes);

}  // namespace plumb
