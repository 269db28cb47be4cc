// SPDX-License-Identifier: MIT
// How is a batch collided and prepared, W lanes at a time?
#pragma once
#include <plumb/collide/lanes/collide_boxes.h>
#include <plumb/collide/lanes/collide_discs.h>
#include <plumb/collide/lanes/collide_polygons.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/lanes/prepare_lanes.h>
#include <plumb/dynamics/contacts/lanes/reuse_lanes.h>

namespace plumb {

template <int W>
struct BatchCollider {
    static void collideBoxes(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh, std::size_t used) {
        for (int lane = 0; lane < static_cast<int>(used); lane += W)
            BoxCollider<W>::collide(pairs, lane, places, fresh);
    }
    static void collideDiscs(const PairLanes& pairs, const BodyPlace* places, const CornerTable& corners,
                             FreshLanes& fresh, std::size_t used) {
        for (int lane = 0; lane < static_cast<int>(used); lane += W)
            DiscCollider<W>::collide(pairs, lane, places, corners, fresh);
    }
    static void collidePolygons(const PairLanes& pairs, const BodyPlace* places, const CornerTable& corners,
                                const std::int32_t* wanted, FreshLanes& fresh, std::size_t used) {
        for (int lane = 0; lane < static_cast<int>(used); lane += W)
            PolygonCollider<W>::collide(pairs, lane, places, corners, wanted, fresh);
    }
    static void reuse(const PairLanes& pairs, const BodyPlace* places, const ManifoldLanes& manifolds,
                      const KeptLanes& kept, FreshLanes& fresh, PoseLanes& now, std::int32_t* again, std::size_t used) {
        for (int lane = 0; lane < static_cast<int>(used); lane += W)
            LaneReuser<W>::reuse(pairs, lane, places, manifolds, kept, fresh, now, again);
    }
    static void prepare(ContactBatch& batch, ManifoldLanes& m, const BodyPlace* places, const SolverVelocity* velocity,
                        const FreshLanes& fresh, const StepLength& step, std::size_t used) {
        for (int lane = 0; lane < static_cast<int>(used); lane += W)
            LanePreparer<W>::prepare(batch, m, lane, places, velocity, fresh, step);
    }
};

template <int W>
const LaneCollider WideLaneCollider<W>::code{BatchCollider<W>::collideBoxes, BatchCollider<W>::collideDiscs,
                                             BatchCollider<W>::collidePolygons, BatchCollider<W>::reuse,
                                             BatchCollider<W>::prepare};

}  // namespace plumb
