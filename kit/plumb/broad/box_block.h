// SPDX-License-Identifier: MIT
// How are boxes stored, so that many are tested at once?
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace plumb {

/// A box in float, relative to some origin.
struct Bounds {
    float lowerX = 0, lowerY = 0, upperX = 0, upperY = 0;
};

/// Structure of arrays. A lane without a box is NaN, and so overlaps nothing.
struct alignas(64) BoxBlock {
    static constexpr std::uint32_t width = 16;
    static constexpr std::size_t maxLevels = 8;  ///< of nested blocks, for 2^32 boxes
    std::array<float, width> lowerX = {}, lowerY = {}, upperX = {}, upperY = {};
};

/// Bit i tells whether the block's box i overlaps or touches a box. Without branches, so that compilers can vectorise
/// it.
template <class Block, class Box>
[[gnu::always_inline]] inline std::uint32_t overlapMask(const Block& block, const Box& box) {
    std::uint32_t mask = 0;
    for (std::uint32_t i = 0; i < block.lowerX.size(); ++i) {
        const std::uint32_t x = (block.lowerX[i] <= box.upperX ? 1u : 0u) & (box.lowerX <= block.upperX[i] ? 1u : 0u);
        const std::uint32_t y = (block.lowerY[i] <= box.upperY ? 1u : 0u) & (box.lowerY <= block.upperY[i] ? 1u : 0u);
        mask |= (x & y) << i;
    }
    return mask;
}

}  // namespace plumb
