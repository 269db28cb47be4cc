// SPDX-License-Identifier: MIT
// How are boxes stored, so that many are tested at once?
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace plumb {

/// A box in float, relative to some origin.
struct Bounds {
    float lowerX, lowerY, upperX, upperY;
};

/// Structure of arrays. A lane without a box is NaN, and so overlaps nothing.
struct alignas(64) BoxBlock {
    static constexpr std::uint32_t width = 16;
    static constexpr std::size_t maxLevels = 8;  ///< of nested blocks, for 2^32 boxes
    std::array<float, width> lowerX, lowerY, upperX, upperY;
};

}  // namespace plumb
