// SPDX-License-Identifier: MIT
// Where does each of a crowd of boxes lie? In an implicit hierarchy that follows them as they move.
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

/// Rounds boxes to float. What overlaps in double does so in float; what overlaps in float by more than a common edge
/// does so in double: rounding keeps the order of any two numbers, or makes them equal.
/// Numbers too large for a float become the largest one; NaN stays.
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

/// A hierarchy without pointers: slots in blocks of 16, one bounding box a block, these in blocks of 16, and so on.
/// Members stand in the order given (mortonOrder is a good one); what is added comes last; what is taken out leaves a
/// hole. Boxes may be put anew at any time: refit mends what was touched, and costs in proportion to that.
/// Each slot has the box that it has now and the one that it had when settle was called.
class BlockTree {
public:
    static constexpr std::uint32_t width = BoxBlock::width;
    static constexpr std::size_t maxLevels = BoxBlock::maxLevels;
    static constexpr std::uint32_t noMember = ~std::uint32_t{0};

    /// What a search reads, as plain memory.
    struct View {
        std::array<const BoxBlock*, maxLevels> levels;  ///< levels[0] has the boxes themselves
        std::uint32_t levelCount;
        const BoxBlock* previous;      ///< of levels[0], when it settled
        const std::uint16_t* touched;  ///< of each block of levels[0], one bit a lane
    };

    /// Makes room for so many slots.
    void reserve(std::size_t slots);
    /// Of memory that it holds.
    std::size_t bytes() const;

    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(members_.size()); }
    std::uint32_t memberCount() const { return memberCount_; }
    /// The member of each slot; noMember in a hole.
    std::span<const std::uint32_t> members() const { return members_; }
    /// The blocks of slots that were touched, in order, from refit until settle.
    std::span<const std::uint32_t> touchedBlocks() const { return touchedBlocks_; }
    View view() const;

    /// Starts anew with these members, whose boxes are to be put.
    void assign(std::span<const std::uint32_t> members);
    /// Returns the slot; its box is to be put.
    std::uint32_t append(std::uint32_t member);
    void erase(std::uint32_t slot);

    void put(std::uint32_t slot, const Bounds& now) { put(levels_[0][slot / width], slot % width, now); }
    void putPrevious(std::uint32_t slot, const Bounds& was) { put(previous_[slot / width], slot % width, was); }
    /// As if the slot had been nowhere when it settled.
    void forgetPrevious(std::uint32_t slot);

    void touch(std::uint32_t slot);
    void touchAll();
    /// Makes the bounds hold the boxes again, where slots were touched; or everywhere. Nothing is to be touched from
    /// then until settle.
    void refitTouched();
    void refitAll();
    /// From now on nothing is touched, and what is now is what was.
    void settle();

    /// Calls visit(slot) for every box that may overlap the given one, as far as floats can tell: for none too few.
    template <class Visit>
    void query(const Bounds& box, Visit&& visit) const;

    /// Calls visit(slot) for every box whose key is the limit or less, nearer ones sooner as far as blocks tell; visit
    /// returns the limit from then on, no larger than it was. Returns the last limit.
    template <class Visit>
    float probe(const BoxProbe& probe, float limit, Visit&& visit) const;

    /// Holds all boxes, as far as they were refitted; NaN when there are none.
    Bounds bounds() const;

    /// The sum of half perimeters over the blocks of slots [m]: grows as the order grows stale.
    double looseness() const;

private:
    static void put(BoxBlock& block, std::uint32_t lane, const Bounds& bounds) {
        block.lowerX[lane] = bounds.lowerX;
        block.lowerY[lane] = bounds.lowerY;
        block.upperX[lane] = bounds.upperX;
        block.upperY[lane] = bounds.upperY;
    }
    static std::uint32_t notAbove(float a, float b) { return a <= b ? 1 : 0; }
    // Bit i tells whether the block's box i overlaps. Without branches, so that compilers can make it wide.
    static std::uint32_t overlaps(const BoxBlock& block, const Bounds& box) {
        std::uint32_t lanes = 0;
        for (std::uint32_t i = 0; i < width; ++i) {
            lanes |= (notAbove(block.lowerX[i], box.upperX) & notAbove(box.lowerX, block.upperX[i]) &
                      notAbove(block.lowerY[i], box.upperY) & notAbove(box.lowerY, block.upperY[i]))
                     << i;
        }
        return lanes;
    }
    Bounds refitBlock(std::size_t level, std::uint32_t block);
    void grow();

    std::vector<std::uint32_t> members_;
    std::uint32_t memberCount_ = 0;
    std::size_t levelCount_ = 0;
    // Box i of levels_[k + 1] holds block i of levels_[k]; the last is one block. Bit i of touched_[k + 1] tells of
    // block i of levels_[k] whether it is to be mended.
    std::array<std::vector<BoxBlock>, maxLevels> levels_;
    std::array<std::vector<std::uint16_t>, maxLevels> touched_;
    std::vector<BoxBlock> previous_;
    std::vector<std::uint32_t> touchedBlocks_;
};

template <class Visit>
void BlockTree::query(const Bounds& box, Visit&& visit) const {
    struct Place {
        std::uint32_t level, block;
    };
    if (levelCount_ == 0) return;
    // Each place taken off puts at most 16 on, one level down.
    std::array<Place, maxLevels*(width - 1) + 1> stack;
    std::size_t size = 0;
    stack[size++] = {static_cast<std::uint32_t>(levelCount_ - 1), 0};
    while (size > 0) {
        const Place place = stack[--size];
        for (std::uint32_t lanes = overlaps(levels_[place.level][place.block], box); lanes != 0; lanes &= lanes - 1) {
            const std::uint32_t i = place.block * width + static_cast<std::uint32_t>(std::countr_zero(lanes));
            if (place.level == 0)
                visit(i);
            else
                stack[size++] = {place.level - 1, i};
        }
    }
}

template <class Visit>
float BlockTree::probe(const BoxProbe& probe, float limit, Visit&& visit) const {
    struct Place {
        float key;
        std::uint32_t level, block;
    };
    if (levelCount_ == 0) return limit;
    std::array<Place, maxLevels*(width - 1) + 1> stack;
    alignas(64) std::array<float, width> keys;
    std::size_t size = 0;
    stack[size++] = {0, static_cast<std::uint32_t>(levelCount_ - 1), 0};
    while (size > 0) {
        const Place place = stack[--size];
        if (place.key > limit) continue;
        const std::size_t first = size;
        std::uint32_t lanes = probe.keys(probe, levels_[place.level][place.block], limit, keys.data());
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
            // The nearest comes to lie on top.
            std::size_t at = size++;
            for (; at > first && stack[at - 1].key < keys[lane]; --at) stack[at] = stack[at - 1];
            stack[at] = {keys[lane], place.level - 1, place.block * width + lane};
        }
        if (place.level > 0) continue;
        for (; size > first; --size)
            if (stack[size - 1].key <= limit) limit = visit(stack[size - 1].block);
    }
    return limit;
}

}  // namespace plumb
