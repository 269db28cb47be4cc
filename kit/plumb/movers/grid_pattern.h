// SPDX-License-Identifier: MIT
// How does a machine without fractions move at 71 % of a pixel per frame?
#pragma once
#include <cstdint>
#include <string>

#include <plumb/math/check.h>

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
inline SpeedPattern speedPattern(int percent) {
    if (percent < 0 || percent > 160 || percent % 5 != 0)
        refuse("speedPattern: percent", std::to_string(percent) + " is not a multiple of 5 from 0 to 160");
    const int set = percent / 5;
    SpeedPattern pattern;
    // Bresenham's line: bit i is set where i set / 32 passes a whole number.
    for (int bit = 0; bit < 32; ++bit)
        pattern.bits = pattern.bits << 1 | static_cast<std::uint32_t>((bit + 1) * set / 32 - bit * set / 32);
    return pattern;
}

}  // namespace plumb
