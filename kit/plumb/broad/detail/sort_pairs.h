// SPDX-License-Identifier: MIT
// How are pairs put in order, found in any?
#pragma once
#include <span>

#include <plumb/broad/pair.h>

namespace plumb {

/// Pairs of count boxes, each once, a < b, by a, then b: a counting sort by a, then each one's b.
SortedPairs sortPairs(std::span<const Pair> found, std::size_t count);

/// The two as a pair.
inline Pair pairOf(std::uint32_t i, std::uint32_t j) {
    return i < j ? Pair{i, j} : Pair{j, i};
}

}  // namespace plumb
