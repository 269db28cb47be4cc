// SPDX-License-Identifier: MIT
// How much is there in a world, and how much is it to make room for?
#pragma once
#include <cstddef>

namespace plumb {

/// What World.reserve is to make room for, so that a world which grows up to there need not move what it has.
struct Capacity {
    std::size_t bodies = 0;
    std::size_t shapes = 0;    ///< a chain counts as many as it has segments
    std::size_t contacts = 0;  ///< pairs of shapes that are near each other
    std::size_t joints = 0;
};

struct WorldCounts {
    std::size_t bodies = 0;
    std::size_t awakeBodies = 0;  ///< dynamic and kinematic
    std::size_t shapes = 0;       ///< a chain is one
    std::size_t joints = 0;
    std::size_t contacts = 0;          ///< pairs of shapes that are near each other, pieces of chains one by one
    std::size_t touchingContacts = 0;  ///< of those
    std::size_t colours = 0;           ///< groups of contacts that the solver goes through one after the other
    std::size_t bytes = 0;             ///< of memory that the world holds, without what the allocator adds to it
};

}  // namespace plumb
