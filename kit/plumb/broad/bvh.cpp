// SPDX-License-Identifier: MIT
#include <plumb/broad/bvh.h>

#include <limits>
#include <utility>

#include <plumb/broad/detail/sorted_pairs.h>
#include <plumb/broad/morton.h>

namespace plumb {
namespace {

constexpr float beyondAll = std::numeric_limits<float>::infinity();
constexpr float largestFloat = std::numeric_limits<float>::max();
constexpr float noBound = std::numeric_limits<float>::quiet_NaN();

// Rounding and subtracting the origin keep the order of numbers, or make them equal: boxes that overlap in double do so
// in float, too. Casting a double beyond the largest float would be undefined.
float inFloat(double x) {
    if (x > largestFloat) return beyondAll;
    if (x < -largestFloat) return -beyondAll;
    return static_cast<float>(x);
}

/// Two blocks of one level, or a block and itself.
struct BlockPair {
    std::uint32_t level, a, b;
};

}  // namespace

Bounds Bvh::rounded(const Aabb& box) const {
    const Vec2 lower = box.lower - origin_;
    const Vec2 upper = box.upper - origin_;
    return {inFloat(lower.x()), inFloat(lower.y()), inFloat(upper.x()), inFloat(upper.y())};
}

// Lanes that hold no box are NaN, and fail every comparison here; so do NaN coordinates.
Bounds Bvh::boundsOf(const Block& block) {
    Bounds all{beyondAll, beyondAll, -beyondAll, -beyondAll};
    for (std::uint32_t i = 0; i < width; ++i) {
        if (block.lowerX[i] < all.lowerX) all.lowerX = block.lowerX[i];
        if (block.lowerY[i] < all.lowerY) all.lowerY = block.lowerY[i];
        if (block.upperX[i] > all.upperX) all.upperX = block.upperX[i];
        if (block.upperY[i] > all.upperY) all.upperY = block.upperY[i];
    }
    return all;
}

void Bvh::put(Block& block, std::uint32_t lane, const Bounds& bounds) {
    block.lowerX[lane] = bounds.lowerX;
    block.lowerY[lane] = bounds.lowerY;
    block.upperX[lane] = bounds.upperX;
    block.upperY[lane] = bounds.upperY;
}

void Bvh::build(std::span<const Aabb> boxes) {
    order_ = mortonOrder(boxes, width);
    boxes_.resize(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) boxes_[k] = boxes[order_[k]];
    // Not the middle of the bounds, which one box far away would move.
    origin_ =
        boxes.empty() ? Vec2(0, 0) : Vec2(0.5 * boxes_[boxes.size() / 2].lower + 0.5 * boxes_[boxes.size() / 2].upper);
    if (!origin_.allFinite()) origin_ = {0, 0};
    buildLevels();
}

void Bvh::buildLevels() {
    // Unused lanes must overlap nothing, not even an infinite box: only NaN does that.
    Block empty;
    for (std::uint32_t lane = 0; lane < width; ++lane) put(empty, lane, {noBound, noBound, noBound, noBound});

    levels_.clear();
    for (std::size_t count = boxes_.size(); count > 0 && (levels_.empty() || count > 1);) {
        std::vector<Block> level((count + width - 1) / width, empty);
        for (std::size_t i = 0; i < count; ++i)
            put(level[i / width], static_cast<std::uint32_t>(i % width),
                levels_.empty() ? rounded(boxes_[i]) : boundsOf(levels_.back()[i]));
        count = level.size();
        levels_.push_back(std::move(level));
    }
}

SortedPairs Bvh::pairs() const {
    return countedPairs().pairs;
}

PairSearch Bvh::countedPairs() const {
    std::uint64_t tests = 0;
    std::vector<Pair> found;
    std::vector<BlockPair> stack;
    if (!levels_.empty()) stack.push_back({static_cast<std::uint32_t>(levels_.size() - 1), 0, 0});
    while (!stack.empty()) {
        const BlockPair at = stack.back();
        stack.pop_back();
        const Block& a = levels_[at.level][at.a];
        const Block& b = levels_[at.level][at.b];
        tests += std::uint64_t{width} * width;
        for (std::uint32_t lane = 0; lane < width; ++lane) {
            const std::uint32_t i = at.a * width + lane;
            std::uint32_t mask = overlapMask(b, Bounds{a.lowerX[lane], a.lowerY[lane], a.upperX[lane], a.upperY[lane]});
            // Within one block every two once; and above the lowest level, each block with itself.
            if (at.a == at.b) mask &= ~std::uint32_t{0} << lane << (at.level == 0 ? 1 : 0);
            for (; mask != 0; mask &= mask - 1) {
                const std::uint32_t j = at.b * width + static_cast<std::uint32_t>(std::countr_zero(mask));
                if (at.level > 0)
                    stack.push_back({at.level - 1, i, j});
                else if (overlap(boxes_[i], boxes_[j]))
                    found.push_back(pairOf(order_[i], order_[j]));
            }
        }
    }
    return {sortPairs(found, order_.size()), tests};
}

}  // namespace plumb
