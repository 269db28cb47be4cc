// SPDX-License-Identifier: MIT
// How does a machine without fractions move at 71 % of a pixel per frame?
#pragma once
#include <cstdint>

namespace plumb {

/// A speed as 32 bits. Each frame uses two, the highest first: one pixel for each bit that is set. It repeats after 16
/// frames. So 100 %, with 20 bits set, is 1.25 pixels per frame.
struct SpeedPattern {
    std::uint32_t bits = 0;

    /// The distance in this frame, counted from any frame: 0, 1 or 2 [pixels].
    constexpr int pixels(std::uint32_t frame) const {
        const std::uint32_t pair = bits >> (30 - 2 * (frame % 16));
        return static_cast<int>((pair & 1) + (pair >> 1 & 1));
    }
    friend bool operator==(const SpeedPattern&, const SpeedPattern&) = default;
};

/// p / 5 bits set, p a speed in percent from 0 to 160, distributed as evenly as possible. The number of bits is that of
/// the arcade; their order in its tables differs. Throws std::invalid_argument on p outside, or that is not a multiple
/// of 5.
/// Source: the numbers of bits: the tables of its program. Test: "speeds of all level bands ..."
SpeedPattern speedPattern(int percent);

}  // namespace plumb
