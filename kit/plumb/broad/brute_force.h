// SPDX-License-Identifier: MIT
// Which boxes overlap? Tests every pair: the reference for the other broad phases.
#pragma once
#include <cstdint>
#include <span>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Tests every two of n boxes: n (n - 1) / 2 tests.
inline PairSearch bruteForcePairs(std::span<const Aabb> boxes) {
    PairSearch search;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (overlap(boxes[a], boxes[b])) search.pairs.push_back({a, b});
        search.tests += count - a - 1;
    }
    return search;
}

}  // namespace plumb
