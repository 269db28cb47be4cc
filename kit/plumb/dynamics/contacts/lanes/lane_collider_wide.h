// SPDX-License-Identifier: MIT
// How is a batch collided and prepared, W lanes at a time?
#pragma once
#include <plumb/dynamics/contacts/lanes/collide_boxes.h>
#include <plumb/dynamics/contacts/lanes/collide_discs.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/lanes/prepare_lanes.h>

namespace plumb {

template <int W>
struct BatchCollider {
    static void collideBoxes(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh) {
        for (int lane = 0; lane < batchLanes; lane += W) BoxCollider<W>::collide(pairs, lane, places, fresh);
    }
    static void collideDiscs(const PairLanes& pairs, const BodyPlace* places, FreshLanes& fresh) {
        for (int lane = 0; lane < batchLanes; lane += W) DiscCollider<W>::collide(pairs, lane, places, fresh);
    }
    static void prepare(ContactBatch& batch, ManifoldLanes& m, const BodyPlace* places, const SolverVelocity* velocity,
                        const FreshLanes& fresh, float inverseStep) {
        for (int lane = 0; lane < batchLanes; lane += W)
            LanePreparer<W>::prepare(batch, m, lane, places, velocity, fresh, inverseStep);
    }
};

template <int W>
const LaneCollider WideLaneCollider<W>::code{BatchCollider<W>::collideBoxes, BatchCollider<W>::collideDiscs,
                                             BatchCollider<W>::prepare};

}  // namespace plumb
