// SPDX-License-Identifier: MIT
// Which functions collide and prepare the contacts of a whole batch? The same templates for each number of lanes.
#pragma once
#include <plumb/collide/lanes/body_place.h>
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

/// How long is the step for which contacts are prepared?
struct StepLength {
    float inverse;  ///< 1/dt [1/s]
    float ratio;    ///< of dt to that of the step from which impulses are carried over: they grow with it [-]
    int halves;     ///< half sub-steps in a step [-]
};

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
