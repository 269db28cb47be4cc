// SPDX-License-Identifier: MIT
#include <plumb/broad/block_tree.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <plumb/math/detail/arrays.h>

namespace plumb {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint16_t allLanes = 0xFFFF;

BoxBlock emptyBlock() {
    BoxBlock block;
    block.lowerX.fill(notANumber);
    block.lowerY.fill(notANumber);
    block.upperX.fill(notANumber);
    block.upperY.fill(notANumber);
    return block;
}

// Four lanes at once, as compilers vectorise this. NaN fails every comparison, and so is skipped.
float smallest(const std::array<float, BoxBlock::width>& values) {
    std::array<float, 4> least{infinity, infinity, infinity, infinity};
    for (std::size_t i = 0; i < values.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k) least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
    const float a = least[0] < least[1] ? least[0] : least[1];
    const float b = least[2] < least[3] ? least[2] : least[3];
    return a < b ? a : b;
}

float greatest(const std::array<float, BoxBlock::width>& values) {
    std::array<float, 4> most{-infinity, -infinity, -infinity, -infinity};
    for (std::size_t i = 0; i < values.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k) most[k] = values[i + k] > most[k] ? values[i + k] : most[k];
    const float a = most[0] > most[1] ? most[0] : most[1];
    const float b = most[2] > most[3] ? most[2] : most[3];
    return a > b ? a : b;
}

Bounds boundsOf(const BoxBlock& block) {
    return {smallest(block.lowerX), smallest(block.lowerY), greatest(block.upperX), greatest(block.upperY)};
}

std::uint16_t bit(std::uint32_t lane) {
    return static_cast<std::uint16_t>(1u << lane);
}

}  // namespace

BlockTree::View BlockTree::view() const {
    View view{};
    for (std::size_t level = 0; level < levelCount_; ++level) view.levels[level] = levels_[level].data();
    view.levelCount = static_cast<std::uint32_t>(levelCount_);
    view.previous = previous_.data();
    view.dirty = dirty_[0].data();
    return view;
}

void BlockTree::assign(std::span<const std::uint32_t> members) {
    members_.assign(members.begin(), members.end());
    memberCount_ = slotCount();
    for (std::size_t level = 0; level < levelCount_; ++level) {
        levels_[level].clear();
        dirty_[level].clear();
    }
    previous_.clear();
    dirtyBlocks_.clear();
    levelCount_ = 0;
    if (!members_.empty()) grow();
}

std::uint32_t BlockTree::append(std::uint32_t member) {
    const std::uint32_t slot = slotCount();
    members_.push_back(member);
    ++memberCount_;
    if (slot % width == 0) grow();
    return slot;
}

void BlockTree::grow() {
    std::size_t blocks = (members_.size() + width - 1) / width;
    previous_.resize(blocks, emptyBlock());
    for (std::size_t level = 0;; ++level) {
        levels_[level].resize(blocks, emptyBlock());
        dirty_[level].resize(blocks, 0);
        if (level == levelCount_) {
            ++levelCount_;
            if (level > 0) dirty_[level][0] = 1;  // the old root becomes a child of the new one
        }
        if (blocks == 1) return;
        blocks = (blocks + width - 1) / width;
    }
}

void BlockTree::reserve(std::size_t slots) {
    std::size_t blocks = (slots + width - 1) / width;
    members_.reserve(slots);
    previous_.reserve(blocks);
    dirtyBlocks_.reserve(blocks);
    for (std::size_t level = 0; blocks > 1; ++level) {
        levels_[level].reserve(blocks);
        dirty_[level].reserve(blocks);
        blocks = (blocks + width - 1) / width;
    }
}

std::size_t BlockTree::bytes() const {
    std::size_t bytes = bytesOf(members_) + bytesOf(previous_) + bytesOf(dirtyBlocks_);
    for (std::size_t level = 0; level < maxLevels; ++level) bytes += bytesOf(levels_[level]) + bytesOf(dirty_[level]);
    return bytes;
}

// The bounds around it stay: they contain the remaining boxes.
void BlockTree::erase(std::uint32_t slot) {
    members_[slot] = noMember;
    --memberCount_;
    put(slot, {notANumber, notANumber, notANumber, notANumber});
    clearPrevious(slot);
}

void BlockTree::clearPrevious(std::uint32_t slot) {
    putPrevious(slot, {notANumber, notANumber, notANumber, notANumber});
}

void BlockTree::markDirty(std::uint32_t slot) {
    for (std::size_t level = 0; level < levelCount_; ++level) {
        std::uint16_t& lanes = dirty_[level][slot / width];
        const bool alreadyMarked = lanes != 0;  // then its parents are marked, too
        lanes = static_cast<std::uint16_t>(lanes | bit(slot % width));
        if (alreadyMarked) return;
        slot /= width;
    }
}

void BlockTree::markAllDirty() {
    std::fill(dirty_[0].begin(), dirty_[0].end(), allLanes);
}

Bounds BlockTree::refitBlock(std::size_t level, std::uint32_t block) {
    std::uint16_t& dirty = dirty_[level][block];
    if (level == 0) {
        if (dirty != 0) dirtyBlocks_.push_back(block);
        return boundsOf(levels_[0][block]);
    }
    for (std::uint32_t lanes = dirty; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
        put(levels_[level][block], lane, refitBlock(level - 1, block * width + lane));
    }
    dirty = 0;
    return boundsOf(levels_[level][block]);
}

void BlockTree::refitDirty() {
    dirtyBlocks_.clear();
    if (levelCount_ > 0) refitBlock(levelCount_ - 1, 0);
}

void BlockTree::refitAll() {
    dirtyBlocks_.clear();
    for (std::uint32_t block = 0; levelCount_ > 0 && block < levels_[0].size(); ++block)
        if (dirty_[0][block] != 0) dirtyBlocks_.push_back(block);
    for (std::size_t level = 1; level < levelCount_; ++level) {
        const std::vector<BoxBlock>& below = levels_[level - 1];
        for (std::uint32_t i = 0; i < below.size(); ++i) put(levels_[level][i / width], i % width, boundsOf(below[i]));
        std::fill(dirty_[level].begin(), dirty_[level].end(), std::uint16_t{0});
    }
}

void BlockTree::storePrevious() {
    for (const std::uint32_t block : dirtyBlocks_) {
        previous_[block] = levels_[0][block];
        dirty_[0][block] = 0;
    }
    dirtyBlocks_.clear();
}

Bounds BlockTree::bounds() const {
    if (levelCount_ == 0) return {notANumber, notANumber, notANumber, notANumber};
    return boundsOf(levels_[levelCount_ - 1][0]);
}

double BlockTree::halfPerimeterSum() const {
    if (levelCount_ < 2) return 0;
    double sum = 0;
    for (std::uint32_t i = 0; i < levels_[0].size(); ++i) {
        const BoxBlock& block = levels_[1][i / width];
        const std::uint32_t lane = i % width;
        const float size = (block.upperX[lane] - block.lowerX[lane]) + (block.upperY[lane] - block.lowerY[lane]);
        if (size > 0 && size < infinity) sum += static_cast<double>(size);
    }
    return sum;
}

}  // namespace plumb
