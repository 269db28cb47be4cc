// SPDX-License-Identifier: MIT
#include <plumb/broad/detail/block_search.h>

#include <plumb/broad/detail/block_search_wide.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

#if defined(__GNUC__)
extern template struct WideBlockSearch<8>;
extern template struct WideBlockSearch<16>;
#endif

namespace {

template <int W>
SearchWork searchWide(const BlockSearch& search, const SlotPairSink& sink) {
    typename WideBlockSearch<W>::Task task{};
    task.levels = search.in.levels.data();
    task.levelCount = search.in.levelCount;
    task.previous = search.in.previous;
    task.dirty = search.in.dirty;
    task.fromBoxes = search.from.levels[0];
    task.fromBounds = search.from.levelCount > 1 ? search.from.levels[1] : nullptr;
    task.fromPrevious = search.from.previous;
    task.fromDirty = search.from.dirty;
    task.blocks = search.blocks.data();
    task.blockCount = static_cast<std::uint32_t>(search.blocks.size());
    task.self = search.target == BlockSearch::Self;
    task.otherSearches = search.target == BlockSearch::OtherSearchesToo;
    task.allDirty = search.allDirty;
    return WideBlockSearch<W>::run(task, sink);
}

}  // namespace

SearchWork searchBlocks(const BlockSearch& search, const SlotPairSink& sink, int lanes) {
    if (search.blocks.empty() || search.in.levelCount == 0) return {0, 0};
    return forLanes(lanes, [&]<int W>() { return searchWide<W>(search, sink); });
}

}  // namespace plumb
