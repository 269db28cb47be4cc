// SPDX-License-Identifier: MIT
// What does every broad phase return?
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

namespace plumb {

/// Two boxes that overlap or touch, by their indices, a < b.
struct Pair {
    std::uint32_t a = 0, b = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// Sorted by a, then b; each pair once.
using SortedPairs = std::vector<Pair>;

/// The pairs that were found, and the number of tests.
struct PairSearch {
    SortedPairs pairs = {};
    std::uint64_t tests = 0;  ///< tests of two boxes for overlap [-]
};

}  // namespace plumb
