// SPDX-License-Identifier: MIT
// Which boxes overlap? Tested with a bounding volume hierarchy.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <plumb/broad/box_block.h>
#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// An implicit hierarchy: boxes in Morton order, in blocks, with bounds built bottom-up; no pointers.
/// Blocks are tested in float, eight boxes at a time; candidates are tested in double. Float coordinates are relative
/// to a box in the middle, so the world may be anywhere; over 1,000 km they resolve 6 cm, and beyond that more and more
/// candidates are left to the test in double.
/// A box with a NaN coordinate overlaps nothing; infinite coordinates are allowed.
/// Time grows as n log n + pairs for evenly distributed boxes; 56 bytes a box.
class Bvh {
public:
    /// Copies the boxes; index i refers to boxes[i] from then on.
    void build(std::span<const Aabb> boxes);

    SortedPairs pairs() const;
    /// The same, with a count. A test is one box, or bounds of a block, against another, eight at a time: 64 for every
    /// two blocks that may share a pair, unused lanes included.
    PairSearch countedPairs() const;

    /// Calls visit(index) for every box that overlaps or touches the given one, in the hierarchy's order.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const;

private:
    static constexpr std::uint32_t width = 8;
    static constexpr std::size_t maxLevels = 11;  // of 8-fold blocks, for 2^32 boxes

    struct Block {
        std::array<float, width> lowerX, lowerY, upperX, upperY;
    };
    struct Node {
        std::uint32_t level, block;
    };

    Bounds rounded(const Aabb& box) const;
    static Bounds boundsOf(const Block& block);
    static void put(Block& block, std::uint32_t lane, const Bounds& bounds);
    void buildLevels();

    std::vector<std::uint32_t> order_;  // order_[k]: the index of the k-th box of the hierarchy
    std::vector<Aabb> boxes_;           // in that order
    Vec2 origin_{0, 0};                 // of the floats [m]
    // levels_[0] has the boxes themselves; box i of levels_[k + 1] contains block i of levels_[k]; the last level is
    // one block.
    std::vector<std::vector<Block>> levels_;
};

template <class Visit>
void Bvh::query(const Aabb& box, Visit&& visit) const {
    if (levels_.empty()) return;
    const Bounds bounds = rounded(box);
    // Each node popped pushes at most eight, one level down.
    std::array<Node, maxLevels*(width - 1) + 1> stack;
    std::size_t size = 0;
    stack[size++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (size > 0) {
        const Node node = stack[--size];
        std::uint32_t mask = overlapMask(levels_[node.level][node.block], bounds);
        if (node.level == 0) {
            for (; mask != 0; mask &= mask - 1) {
                const std::size_t k =
                    node.block * std::size_t{width} + static_cast<std::size_t>(std::countr_zero(mask));
                if (overlap(boxes_[k], box)) visit(order_[k]);
            }
            continue;
        }
        while (mask != 0) {  // the last first, so that the first is popped next
            const auto lane = static_cast<std::uint32_t>(std::bit_width(mask) - 1);
            mask ^= std::uint32_t{1} << lane;
            stack[size++] = {node.level - 1, node.block * width + lane};
        }
    }
}

}  // namespace plumb
