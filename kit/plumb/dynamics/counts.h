// SPDX-License-Identifier: MIT
// How many objects does a world have, and for how many does it reserve memory?
#pragma once
#include <cstddef>

namespace plumb {

/// The numbers for which World.reserve reserves memory. A world that grows up to them does not need to reallocate.
struct Capacity {
    std::size_t bodies = 0;
    std::size_t shapes = 0;    ///< a chain counts as the number of its segments
    std::size_t contacts = 0;  ///< pairs of shapes that are near each other
    std::size_t joints = 0;
};

struct WorldCounts {
    std::size_t bodies = 0;
    std::size_t awakeBodies = 0;  ///< dynamic and kinematic
    std::size_t shapes = 0;       ///< a chain counts as one
    std::size_t joints = 0;
    std::size_t contacts = 0;          ///< pairs of shapes that are near each other; each piece of a chain counts
    std::size_t touchingContacts = 0;  ///< contacts that touch
    std::size_t colours = 0;           ///< groups of contacts that the solver handles one after the other
    std::size_t bytes = 0;             ///< of memory that the world holds, without what the allocator adds to it
};

}  // namespace plumb
