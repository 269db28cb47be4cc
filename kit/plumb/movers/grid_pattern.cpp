// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_pattern.h>

#include <string>

#include <plumb/math/check.h>

namespace plumb {

SpeedPattern speedPattern(int percent) {
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
