// SPDX-License-Identifier: MIT
// Which of many moving boxes overlap? An implicit bounding volume hierarchy that is refitted as they move.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <plumb/broad/box_block.h>
#include <plumb/broad/box_probe.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Rounds boxes to float. Boxes that overlap in double do so in float; boxes that overlap in float by more than a
/// common edge do so in double: rounding keeps the order of two numbers, or makes them equal.
/// Numbers too large for a float become the largest float; NaN stays NaN.
class BoundsRounding {
public:
    explicit BoundsRounding(const Vec2& origin) : origin_(origin) {}
    Bounds operator()(const Aabb& box) const {
        return {round(box.lower.x() - origin_.x()), round(box.lower.y() - origin_.y()),
                round(box.upper.x() - origin_.x()), round(box.upper.y() - origin_.y())};
    }

private:
    static float round(double x) {
        constexpr double largest = 0x1.fffffep127;
        x = x > largest ? largest : x;
        return static_cast<float>(x < -largest ? -largest : x);
    }
    Vec2 origin_;
};

/// A hierarchy without pointers: slots in blocks of 16, one bounding box per block, these in blocks of 16, and so on.
/// Members are in the order given (mortonOrder is a good one); an added member comes last; a removed one leaves a hole.
/// Boxes may be changed at any time: refitting updates the blocks marked dirty, and costs in proportion to them.
/// Each slot has its present box and its previous one, from the last call of storePrevious.
class BlockTree {
public:
    static constexpr std::uint32_t width = BoxBlock::width;
    static constexpr std::size_t maxLevels = BoxBlock::maxLevels;
    static constexpr std::uint32_t noMember = ~std::uint32_t{0};

    /// What a search reads, as plain arrays.
    struct View {
        std::array<const BoxBlock*, maxLevels> levels;  ///< levels[0] has the boxes themselves
        std::uint32_t levelCount;
        const BoxBlock* previous;    ///< boxes of levels[0] at the last storePrevious
        const std::uint16_t* dirty;  ///< dirty bits of each block of levels[0], one bit a lane
    };

    /// Reserves memory for so many slots.
    void reserve(std::size_t slots);
    /// Memory in use.
    std::size_t bytes() const;

    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(members_.size()); }
    std::uint32_t memberCount() const { return memberCount_; }
    /// The member of each slot; noMember in a hole.
    std::span<const std::uint32_t> members() const { return members_; }
    /// The blocks with dirty slots, in order; valid from refit until storePrevious.
    std::span<const std::uint32_t> dirtyBlocks() const { return dirtyBlocks_; }
    View view() const;

    /// Replaces all members; their boxes have to be put afterwards.
    void assign(std::span<const std::uint32_t> members);
    /// Returns the slot; its box has to be put afterwards.
    std::uint32_t append(std::uint32_t member);
    void erase(std::uint32_t slot);

    void put(std::uint32_t slot, const Bounds& now) { put(levels_[0][slot / width], slot % width, now); }
    void putPrevious(std::uint32_t slot, const Bounds& was) { put(previous_[slot / width], slot % width, was); }
    /// As if the slot had been empty at the last storePrevious.
    void clearPrevious(std::uint32_t slot);

    void markDirty(std::uint32_t slot);
    void markAllDirty();
    /// Makes the bounds contain the boxes again: where slots are dirty, or everywhere. No slot may be marked dirty from
    /// then until storePrevious.
    void refitDirty();
    void refitAll();
    /// Copies the dirty boxes to the previous ones, and clears the dirty marks.
    void storePrevious();

    /// Calls visit(slot) for every box that may overlap the given one: in float, so sometimes one too many, never one
    /// too few.
    template <class Visit>
    void query(const Bounds& box, Visit&& visit) const;

    /// Calls visit(slot) for every box whose key is at most the limit, nearer ones first as far as blocks tell; visit
    /// returns the new limit, no larger than before. Returns the last limit.
    template <class Visit>
    float probe(const BoxProbe& probe, float limit, Visit&& visit) const;

    /// Contains all boxes as of the last refit; NaN when there are none.
    Bounds bounds() const;

    /// The sum of half perimeters over the blocks of slots [m]: a cost that grows when the order no longer fits the
    /// positions.
    double halfPerimeterSum() const;

private:
    static void put(BoxBlock& block, std::uint32_t lane, const Bounds& bounds) {
        block.lowerX[lane] = bounds.lowerX;
        block.lowerY[lane] = bounds.lowerY;
        block.upperX[lane] = bounds.upperX;
        block.upperY[lane] = bounds.upperY;
    }
    Bounds refitBlock(std::size_t level, std::uint32_t block);
    void grow();

    std::vector<std::uint32_t> members_;
    std::uint32_t memberCount_ = 0;
    std::size_t levelCount_ = 0;
    // Box i of levels_[k + 1] contains block i of levels_[k]; the last level is one block. Bit i of dirty_[k + 1] tells
    // whether block i of levels_[k] has to be refitted.
    std::array<std::vector<BoxBlock>, maxLevels> levels_;
    std::array<std::vector<std::uint16_t>, maxLevels> dirty_;
    std::vector<BoxBlock> previous_;
    std::vector<std::uint32_t> dirtyBlocks_;
};

template <class Visit>
void BlockTree::query(const Bounds& box, Visit&& visit) const {
    struct Node {
        std::uint32_t level, block;
    };
    if (levelCount_ == 0) return;
    // Each node popped pushes at most 16, one level down.
    std::array<Node, maxLevels*(width - 1) + 1> stack;
    std::size_t size = 0;
    stack[size++] = {static_cast<std::uint32_t>(levelCount_ - 1), 0};
    while (size > 0) {
        const Node node = stack[--size];
        for (std::uint32_t lanes = overlapMask(levels_[node.level][node.block], box); lanes != 0; lanes &= lanes - 1) {
            const std::uint32_t i = node.block * width + static_cast<std::uint32_t>(std::countr_zero(lanes));
            if (node.level == 0)
                visit(i);
            else
                stack[size++] = {node.level - 1, i};
        }
    }
}

template <class Visit>
float BlockTree::probe(const BoxProbe& probe, float limit, Visit&& visit) const {
    struct Node {
        float key;
        std::uint32_t level, block;
    };
    if (levelCount_ == 0) return limit;
    std::array<Node, maxLevels*(width - 1) + 1> stack;
    alignas(64) std::array<float, width> keys;
    std::size_t size = 0;
    stack[size++] = {0, static_cast<std::uint32_t>(levelCount_ - 1), 0};
    while (size > 0) {
        const Node node = stack[--size];
        if (node.key > limit) continue;
        const std::size_t first = size;
        std::uint32_t lanes = probe.keys(probe, levels_[node.level][node.block], limit, keys.data());
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
            // The nearest ends on top.
            std::size_t at = size++;
            for (; at > first && stack[at - 1].key < keys[lane]; --at) stack[at] = stack[at - 1];
            stack[at] = {keys[lane], node.level - 1, node.block * width + lane};
        }
        if (node.level > 0) continue;
        for (; size > first; --size)
            if (stack[size - 1].key <= limit) limit = visit(stack[size - 1].block);
    }
    return limit;
}

}  // namespace plumb
