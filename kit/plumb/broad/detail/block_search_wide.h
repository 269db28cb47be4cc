// SPDX-License-Identifier: MIT
// How does a block of boxes find overlapping boxes, W at a time?
#pragma once
#include <cmath>

#include <plumb/broad/box_block.h>
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

// What a search of a block tree gives.

/// Two slots whose boxes may overlap now and did not before, in float: no pair is missed; a pair too many has edges
/// that are equal when rounded.
struct SlotPair {
    std::uint32_t a, b;
};

/// The work done, in units that take about the same time on any machine.
struct SearchWork {
    std::uint64_t blocks;  ///< 16 boxes tested against the bounds of one block's dirty slots
    std::uint64_t boxes;   ///< one box tested against the 16 of a block
};

/// Receives the pairs that are found, in batches.
struct SlotPairSink {
    void (*take)(void* receiver, const SlotPair* pairs, std::uint32_t count);
    void* receiver;
};

/// Plain arrays and templates over W only, and no Eigen: see math/detail/wide.h.
template <int W>
struct WideBlockSearch {
    /// BlockSearch as plain arrays.
    struct Task {
        const BoxBlock* const* levels;
        std::uint32_t levelCount;
        const BoxBlock* previous;
        const std::uint16_t* dirty;
        const BoxBlock* fromBoxes;
        const BoxBlock* fromBounds;  ///< of the level above, if there is one
        const BoxBlock* fromPrevious;
        const std::uint16_t* fromDirty;
        const std::uint32_t* blocks;
        std::uint32_t blockCount;
        bool self, otherSearches, allDirty;
    };
    static SearchWork run(const Task& task, const SlotPairSink& sink);

private:
    using Float = typename Wide<W>::Float;
    using Mask = typename Wide<W>::Mask;
    static constexpr std::uint32_t width = 16;
    static constexpr std::uint32_t lowerX = 0, lowerY = width, upperX = 2 * width, upperY = 3 * width;
    static constexpr std::uint32_t bufferSize = 256;
    /// Block against block is faster up to so many candidates for each searching slot (measured).
    static constexpr std::uint32_t maxPerSearching = 16;
    static constexpr std::uint32_t maxGathered = 64;

    using Box = Bounds;
    struct Node {
        std::uint32_t level, block;
    };
    struct Gathered {
        std::uint32_t block, lanes;
    };

    // A block as plain floats: inline functions of std::array must not be emitted here.
    static const float* boxesOf(const BoxBlock& block);
    static Box boxOf(const float* boxes, std::uint32_t lane);
    static Box boundsOf(const float* boxes, std::uint32_t lanes);
    static std::uint32_t lowestBit(std::uint32_t bits);
    static std::uint32_t countOf(std::uint32_t bits);
    static Mask both(const Mask& a, const Mask& b);
    static Mask overlap(const float* boxes, const Box& box);
    static Mask overlapBeyondEdges(const float* boxes, const Box& box);
    static std::uint32_t overlaps(const float* boxes, const Box& box);
    static std::uint32_t newOverlaps(const float* boxes, const float* were, const Box& box, const Box& was);
    static std::uint32_t lanesFrom(std::uint32_t block, const Node& node);

    WideBlockSearch(const Task& t, const SlotPairSink& s) : task(t), sink(s) {}
    void searchBlock(std::uint32_t block);
    bool gather(std::uint32_t block, const Box& bounds, std::uint32_t searching);
    void compare(std::uint32_t block, const Gathered& other);
    void searchLane(std::uint32_t block, std::uint32_t lane);
    template <class Visit>
    bool descend(std::uint32_t block, const Box& bounds, Visit&& visit);
    void report(std::uint32_t a, std::uint32_t b);
    void flush();

    const Task& task;
    const SlotPairSink& sink;
    std::uint64_t blockTests = 0, boxTests = 0;
    std::uint32_t count = 0;
    std::uint32_t gatheredCount = 0;
    Gathered gathered[maxGathered];
    SlotPair buffer[bufferSize];
};

// The arrays of a block are adjacent, without gaps.
template <int W>
[[gnu::always_inline]] inline const float* WideBlockSearch<W>::boxesOf(const BoxBlock& block) {
    static_assert(sizeof(BoxBlock) == 4 * width * sizeof(float));
    return reinterpret_cast<const float*>(&block);
}

template <int W>
[[gnu::always_inline]] inline typename WideBlockSearch<W>::Box WideBlockSearch<W>::boxOf(const float* boxes,
                                                                                         std::uint32_t lane) {
    return {boxes[lowerX + lane], boxes[lowerY + lane], boxes[upperX + lane], boxes[upperY + lane]};
}

template <int W>
typename WideBlockSearch<W>::Box WideBlockSearch<W>::boundsOf(const float* boxes, std::uint32_t lanes) {
    constexpr float infinity = HUGE_VALF;
    Box box{infinity, infinity, -infinity, -infinity};
    for (; lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t lane = lowestBit(lanes);
        // A lane without a box fails every comparison.
        box.lowerX = boxes[lowerX + lane] < box.lowerX ? boxes[lowerX + lane] : box.lowerX;
        box.lowerY = boxes[lowerY + lane] < box.lowerY ? boxes[lowerY + lane] : box.lowerY;
        box.upperX = boxes[upperX + lane] > box.upperX ? boxes[upperX + lane] : box.upperX;
        box.upperY = boxes[upperY + lane] > box.upperY ? boxes[upperY + lane] : box.upperY;
    }
    return box;
}

template <int W>
std::uint32_t WideBlockSearch<W>::lowestBit(std::uint32_t bits) {
#if defined(__GNUC__)
    return static_cast<std::uint32_t>(__builtin_ctz(bits));
#else
    std::uint32_t lane = 0;
    while ((bits >> lane & 1) == 0) ++lane;
    return lane;
#endif
}

template <int W>
std::uint32_t WideBlockSearch<W>::countOf(std::uint32_t bits) {  // of 16
    bits -= bits >> 1 & 0x5555;
    bits = (bits & 0x3333) + (bits >> 2 & 0x3333);
    bits = (bits + (bits >> 4)) & 0x0F0F;
    return (bits + (bits >> 8)) & 0x1F;
}

template <int W>
[[gnu::always_inline]] inline typename WideBlockSearch<W>::Mask WideBlockSearch<W>::both(const Mask& a, const Mask& b) {
    if constexpr (W == 1)
        return a && b;
    else
        return a & b;
}

template <int W>
[[gnu::always_inline]] inline typename WideBlockSearch<W>::Mask WideBlockSearch<W>::overlap(const float* boxes,
                                                                                            const Box& box) {
    const Mask x = both(loadLanes<W>(boxes + lowerX) <= box.upperX, loadLanes<W>(boxes + upperX) >= box.lowerX);
    const Mask y = both(loadLanes<W>(boxes + lowerY) <= box.upperY, loadLanes<W>(boxes + upperY) >= box.lowerY);
    return both(x, y);
}

template <int W>
[[gnu::always_inline]] inline typename WideBlockSearch<W>::Mask WideBlockSearch<W>::overlapBeyondEdges(
    const float* boxes, const Box& box) {
    const Mask x = both(loadLanes<W>(boxes + lowerX) < box.upperX, loadLanes<W>(boxes + upperX) > box.lowerX);
    const Mask y = both(loadLanes<W>(boxes + lowerY) < box.upperY, loadLanes<W>(boxes + upperY) > box.lowerY);
    return both(x, y);
}

template <int W>
[[gnu::always_inline]] inline std::uint32_t WideBlockSearch<W>::overlaps(const float* boxes, const Box& box) {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < width; i += W) bits |= bitsOf<W>(overlap(boxes + i, box)) << i;
    return bits;
}

// Boxes may overlap now if they do in float; they surely did before if they overlapped in float by more than an edge:
// so rounding never hides a pair.
template <int W>
[[gnu::always_inline]] inline std::uint32_t WideBlockSearch<W>::newOverlaps(const float* boxes, const float* were,
                                                                            const Box& box, const Box& was) {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < width; i += W) {
        const Mask now = overlap(boxes + i, box);
        const Mask then = overlapBeyondEdges(were + i, was);
        if constexpr (W == 1)
            bits |= bitsOf<W>(now && !then) << i;
        else
            bits |= bitsOf<W>(now & ~then) << i;
    }
    return bits;
}

/// Which lanes of a node's block contain slots of this block or of later ones?
template <int W>
std::uint32_t WideBlockSearch<W>::lanesFrom(std::uint32_t block, const Node& node) {
    const std::uint32_t first = block >> 4 * (node.level - 1);  // on the level below the node's
    const std::uint32_t begin = node.block * width;
    return first <= begin ? 0xFFFF : 0xFFFFu << (first - begin);
}

/// Calls visit(block) for the blocks of boxes whose bounds are in reach, until visit returns false.
template <int W>
template <class Visit>
bool WideBlockSearch<W>::descend(std::uint32_t block, const Box& bounds, Visit&& visit) {
    // Each node popped pushes at most 16, one level down.
    Node stack[BoxBlock::maxLevels * (width - 1) + 1];
    std::uint32_t size = 0;
    stack[size++] = {task.levelCount - 1, 0};
    while (size > 0) {
        const Node node = stack[--size];
        if (node.level == 0) {
            if (!visit(node.block)) return false;
            continue;
        }
        ++blockTests;
        std::uint32_t lanes = overlaps(boxesOf(task.levels[node.level][node.block]), bounds);
        if (task.self && task.allDirty) lanes &= lanesFrom(block, node);
        for (; lanes != 0; lanes &= lanes - 1) stack[size++] = {node.level - 1, node.block * width + lowestBit(lanes)};
    }
    return true;
}

template <int W>
void WideBlockSearch<W>::searchBlock(std::uint32_t block) {
    const std::uint32_t searching = task.fromDirty[block];
    const float* boxes = boxesOf(task.fromBoxes[block]);
    // Where all slots search, the level above has their bounds.
    const Box bounds = searching == 0xFFFF && task.fromBounds != nullptr
                           ? boxOf(boxesOf(task.fromBounds[block / width]), block % width)
                           : boundsOf(boxes, searching);
    if ((searching & (searching - 1)) != 0 && gather(block, bounds, searching)) {
        for (std::uint32_t i = 0; i < gatheredCount; ++i) compare(block, gathered[i]);
        return;
    }
    for (std::uint32_t lanes = searching; lanes != 0; lanes &= lanes - 1) searchLane(block, lowestBit(lanes));
}

/// Lists the candidates for all searching slots of a block; false if there are so many that one search per slot is
/// faster.
template <int W>
bool WideBlockSearch<W>::gather(std::uint32_t block, const Box& bounds, std::uint32_t searching) {
    std::uint32_t left = maxPerSearching * countOf(searching);
    gatheredCount = 0;
    return descend(block, bounds, [&](std::uint32_t other) {
        ++blockTests;
        std::uint32_t lanes = overlaps(boxesOf(task.levels[0][other]), bounds);
        if (task.otherSearches || (task.self && other < block)) lanes &= ~task.dirty[other];  // those find the pair
        if (lanes == 0) return true;
        const std::uint32_t more = countOf(lanes);
        if (more > left || gatheredCount == maxGathered) return false;
        left -= more;
        gathered[gatheredCount++] = {other, lanes};
        return true;
    });
}

/// Tests the searching slots of a block against candidates in another block, or in the same one.
template <int W>
void WideBlockSearch<W>::compare(std::uint32_t block, const Gathered& other) {
    const std::uint32_t searching = task.fromDirty[block];
    const bool same = task.self && other.block == block;
    const float* boxes = boxesOf(task.fromBoxes[block]);
    const float* were = boxesOf(task.fromPrevious[block]);
    const float* otherBoxes = boxesOf(task.levels[0][other.block]);
    const float* otherWere = boxesOf(task.previous[other.block]);
    for (std::uint32_t lanes = other.lanes; lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t lane = lowestBit(lanes);
        std::uint32_t found = searching & newOverlaps(boxes, were, boxOf(otherBoxes, lane), boxOf(otherWere, lane));
        ++boxTests;
        // Within a block every two once: found by the first of two that search.
        if (same) found &= searching >> lane & 1 ? (1u << lane) - 1 : ~0u;
        for (; found != 0; found &= found - 1) report(block * width + lowestBit(found), other.block * width + lane);
    }
}

/// Searches the whole tree for one slot.
template <int W>
void WideBlockSearch<W>::searchLane(std::uint32_t block, std::uint32_t lane) {
    const Box box = boxOf(boxesOf(task.fromBoxes[block]), lane);
    const Box was = boxOf(boxesOf(task.fromPrevious[block]), lane);
    descend(block, box, [&](std::uint32_t other) {
        ++boxTests;
        std::uint32_t found = newOverlaps(boxesOf(task.levels[0][other]), boxesOf(task.previous[other]), box, was);
        if (task.otherSearches || (task.self && other < block)) found &= ~std::uint32_t{task.dirty[other]};
        if (task.self && other == block) found &= ~(task.dirty[block] & ((2u << lane) - 1));
        for (; found != 0; found &= found - 1) report(block * width + lane, other * width + lowestBit(found));
        return true;
    });
}

template <int W>
void WideBlockSearch<W>::report(std::uint32_t a, std::uint32_t b) {
    buffer[count++] = {a, b};
    if (count == bufferSize) flush();
}

template <int W>
void WideBlockSearch<W>::flush() {
    if (count > 0) sink.take(sink.receiver, buffer, count);
    count = 0;
}

template <int W>
SearchWork WideBlockSearch<W>::run(const Task& task, const SlotPairSink& sink) {
    WideBlockSearch search(task, sink);
    for (std::uint32_t i = 0; i < task.blockCount; ++i) search.searchBlock(task.blocks[i]);
    search.flush();
    return {search.blockTests, search.boxTests};
}

}  // namespace plumb
