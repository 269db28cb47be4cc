// SPDX-License-Identifier: MIT
// What has happened to a world, and who has not been told yet?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/dynamics/events.h>
#include <plumb/dynamics/state/tile_store.h>

namespace plumb {

/// Of the last step.
struct WorldEvents {
    std::vector<ContactBegin> begins;
    std::vector<ContactEnd> ends;
    std::size_t reportedEnds = 0;  ///< of ends: those of the last step; what was removed since comes after them
    std::vector<ContactHit> hits;
    std::vector<JointBroke> breaks;
    std::vector<Quarantined> quarantines;
    std::vector<BodyIndex> movers;    ///< bodies that were awake
    std::vector<BodyIndex> sleepers;  ///< of those: they fell asleep at its end
    std::vector<BodyIndex> gone;      ///< slots of bodies that were removed since

    /// At the start of a step: forgets all but the ends since the last one.
    void clear();
    void add(const TouchEvents& touches, const BodyStore& bodies, const Space& space, const TileStore& tiles);
    void addEnds(const std::vector<TouchEnd>& touchEnds, const BodyStore& bodies, const Space& space);
};

}  // namespace plumb
