// SPDX-License-Identifier: MIT
// Which boxes of one hierarchy overlap boxes of another, and did not before?
#pragma once
#include <cstdint>
#include <span>

#include <plumb/broad/block_tree.h>

namespace plumb {

// Defined in block_search_wide.h.
struct SearchWork;
struct SlotPairSink;

struct BlockSearch {
    BlockTree::View from;                           ///< its dirty slots are searched for
    std::span<const std::uint32_t> blocks;          ///< of from: those with dirty slots
    BlockTree::View in;                             ///< which is searched
    enum { Self, Other, OtherSearchesToo } target;  ///< from itself, another tree, or one that searches as well
    bool allDirty = false;                          ///< of from itself: every slot of each block is dirty
};

/// Each pair once, in the same order for any number of lanes: 1, 4, 8 or 16, no more than the machine has.
SearchWork searchBlocks(const BlockSearch& search, const SlotPairSink& sink, int lanes);

}  // namespace plumb
