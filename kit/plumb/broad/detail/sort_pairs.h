// SPDX-License-Identifier: MIT
// How are pairs sorted that were found in any order?
#pragma once
#include <span>

#include <plumb/broad/pair.h>

namespace plumb {

/// Pairs of count boxes, each once, a < b, sorted by a, then b: a counting sort by a, then a sort of each group by b.
SortedPairs sortPairs(std::span<const Pair> found, std::size_t count);

/// The pair of the two, the smaller index first.
inline Pair pairOf(std::uint32_t i, std::uint32_t j) {
    return i < j ? Pair{i, j} : Pair{j, i};
}

}  // namespace plumb
