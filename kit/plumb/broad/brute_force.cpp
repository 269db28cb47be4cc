// SPDX-License-Identifier: MIT
#include <plumb/broad/brute_force.h>

namespace plumb {

SortedPairs bruteForcePairs(std::span<const Aabb> boxes) {
    SortedPairs pairs;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (overlap(boxes[a], boxes[b])) pairs.push_back({a, b});
    return pairs;
}

}  // namespace plumb
