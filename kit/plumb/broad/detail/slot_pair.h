// SPDX-License-Identifier: MIT
// What does a search of a block tree return?
#pragma once
#include <cstdint>

namespace plumb {

/// Two slots whose boxes may overlap now and did not before, in float: no pair is missed; a pair too many has edges
/// that are equal when rounded.
struct SlotPair {
    std::uint32_t a, b;
};

/// The work done, in units that take about the same time on any machine.
struct SearchWork {
    std::uint64_t blocks;  ///< 16 boxes tested against the bounds of one block's dirty slots
    std::uint64_t boxes;   ///< one box tested against the 16 of a block
};

/// Receives the pairs that are found, in batches.
struct SlotPairSink {
    void (*take)(void* receiver, const SlotPair* pairs, std::uint32_t count);
    void* receiver;
};

}  // namespace plumb
