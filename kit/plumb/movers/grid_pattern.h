// SPDX-License-Identifier: MIT
// How does a machine without fractions move at 71 % of a pixel a frame?
#pragma once
#include <cstdint>

namespace plumb {

/// A speed as 32 bits, of which each frame takes two, the highest first: a pixel for each that is set. After 16 frames
/// it begins anew. So 100 %, with 20 bits set, is 1.25 pixels a frame.
struct SpeedPattern {
    std::uint32_t bits = 0;

    /// How far in this frame, counted from any: 0, 1 or 2 [pixels].
    constexpr int pixels(std::uint32_t frame) const {
        const std::uint32_t pair = bits >> (30 - 2 * (frame % 16));
        return static_cast<int>((pair & 1) + (pair >> 1 & 1));
    }
    friend bool operator==(const SpeedPattern&, const SpeedPattern&) = default;
};

/// p / 5 bits set, p a speed in percent from 0 to 160, spread as evenly as can be. The arcade's counts are these; their
/// order in its tables is its own. Throws std::invalid_argument on p outside, or that is no multiple of 5.
/// Source: the counts, its program's tables. Test: "speeds of all level bands ..."
SpeedPattern speedPattern(int percent);

}  // namespace plumb
