// SPDX-License-Identifier: MIT
// In which order are the blocks of a sparse symmetric system eliminated?
//
// The node with the fewest neighbours is taken first, and a constraint only after one of the unknowns in it: alone, its
// block is almost zero, and dividing by it would lose digits. A tree is therefore eliminated from its leaves, without
// any new blocks (fill-in), at a cost proportional to its size. The order depends on the graph alone, so equal systems
// share one plan.
// Source: minimum degree: Tinney, Walker, Proc. IEEE 55 (1967) 1801.
// Test: "a tree of 10,000 nodes takes at most three block updates a node"
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <plumb/math/detail/arrays.h>

namespace plumb {

struct BlockPlan {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;  ///< joins two different nodes

    struct Lower {
        std::uint32_t node = 0;   ///< eliminated later
        std::uint32_t block = 0;  ///< index of the block (node, eliminated node)
    };
    struct Place {
        std::uint32_t block = 0;
        bool transposed = false;
    };
    struct Update {
        std::uint32_t target = 0, left = 0, right = 0;  ///< target -= left D^-1 right^T
    };
    struct Step {
        std::uint32_t node = 0;
        std::uint32_t firstLower = 0, firstUpdate = 0;
    };

    std::uint32_t blocks = 0;   ///< their number; those of the diagonal come first
    std::vector<Place> places;  ///< for each edge, where its block is
    std::vector<Step> steps;    ///< in the order of elimination, and one past the end
    std::vector<Lower> lowers;
    std::vector<Update> updates;

    std::size_t bytes() const { return bytesOf(places) + bytesOf(steps) + bytesOf(lowers) + bytesOf(updates); }
};

/// The plan for a graph, in which the first nodes are unknowns and the others constraints, as bodies and joints are;
/// null if the elimination would take more than mostUpdates block updates. fromWalls: an unknown that has a constraint
/// for itself counts as an end. So a chain between two walls has two ends, which go in turn; but what is hung up at
/// such an end becomes almost rigid when that is eliminated, and loses digits.
std::shared_ptr<const BlockPlan> planBlocks(std::uint32_t unknowns, std::uint32_t constraints,
                                            std::span<const BlockPlan::Edge> edges, std::size_t mostUpdates,
                                            bool fromWalls = false);

}  // namespace plumb
