// SPDX-License-Identifier: MIT
// Which boxes of one hierarchy overlap which of another, that did not before?
#pragma once
#include <cstdint>
#include <span>

#include <plumb/broad/block_tree.h>
#include <plumb/broad/detail/slot_pair.h>

namespace plumb {

struct BlockSearch {
    BlockTree::View from;                          ///< whose touched slots ask
    std::span<const std::uint32_t> blocks;         ///< of from: those with touched slots
    BlockTree::View in;                            ///< which is asked
    enum { Itself, Another, AnotherThatAsks } is;  ///< in: from itself; another; or one whose touched slots ask as well
    bool allTouched = false;                       ///< of itself: every slot of each block
};

/// Each pair once, in the same order for any number of lanes: 1, 4, 8 or 16, no more than the machine has.
SearchWork searchBlocks(const BlockSearch& search, const SlotPairSink& sink, int lanes);

}  // namespace plumb
