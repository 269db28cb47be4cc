// SPDX-License-Identifier: MIT
// What do the broad phases share? Boxes whose corners are in order, and pairs that are sorted in the end.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include <plumb/broad/pair.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Inverted boxes overlap boxes that extend across them: boxes that overlap also do so when their corners are ordered.
inline Aabb ordered(const Aabb& box) {
    return {box.lower.cwiseMin(box.upper), box.lower.cwiseMax(box.upper)};
}

/// A box with such a coordinate overlaps nothing.
inline bool hasNaN(const Aabb& box) {
    return box.lower.hasNaN() || box.upper.hasNaN();
}

/// The pair of the two, the smaller index first.
inline Pair pairOf(std::uint32_t i, std::uint32_t j) {
    return i < j ? Pair{i, j} : Pair{j, i};
}

/// Pairs of count boxes, each once, a < b, sorted by a, then b: a counting sort by a, then a sort of each group by b.
inline SortedPairs sortPairs(std::span<const Pair> found, std::size_t count) {
    std::vector<std::size_t> starts(count + 1);
    for (const Pair& pair : found) ++starts[pair.a + std::size_t{1}];
    for (std::size_t i = 0; i < count; ++i) starts[i + 1] += starts[i];
    SortedPairs pairs(found.size());
    for (const Pair& pair : found) pairs[starts[pair.a]++] = pair;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < count; ++i) {  // by now starts[i] is where i's pairs end
        std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin),
                  pairs.begin() + static_cast<std::ptrdiff_t>(starts[i]));
        begin = starts[i];
    }
    return pairs;
}

}  // namespace plumb
