// SPDX-License-Identifier: MIT
// What has happened to a world, and which of it has not been reported yet?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/events.h>
#include <plumb/dynamics/state/tile_store.h>

namespace plumb {

/// The events of the last step.
struct WorldEvents {
    std::vector<ContactBegin> begins;
    std::vector<ContactEnd> ends;
    std::size_t reportedEnds = 0;  ///< number of ends of the last step; ends by later removals come after them
    std::vector<ContactHit> hits;
    std::vector<JointBroke> breaks;
    std::vector<Quarantined> quarantines;
    std::vector<BodyIndex> movers;    ///< bodies that were awake
    std::vector<BodyIndex> sleepers;  ///< those of the movers that fell asleep at the step's end
    std::vector<BodyIndex> gone;      ///< slots of bodies that were removed since the step

    /// At the start of a step: removes all events except the ends since the last step.
    void clear();
    void add(const TouchEvents& touches, const BodyStore& bodies, const Space& space, const TileStore& tiles);
    void addEnds(std::span<const TouchEnd> touchEnds, const BodyStore& bodies, const Space& space);
};

}  // namespace plumb
