// SPDX-License-Identifier: MIT
// What does a search through blocks of boxes give?
#pragma once
#include <cstdint>

namespace plumb {

/// Two slots whose boxes may overlap now and did not before, as far as floats can tell: what they miss is nothing, what
/// they add are edges that are the same when rounded.
struct SlotPair {
    std::uint32_t a, b;
};

/// How much was done, in units that take about as long on any machine.
struct SearchWork {
    std::uint64_t blocks;  ///< 16 boxes tested against the bounds of one block's touched slots
    std::uint64_t boxes;   ///< one box tested against the 16 of a block
};

/// What is found goes there, some at a time.
struct SlotPairSink {
    void (*take)(void* receiver, const SlotPair* pairs, std::uint32_t count);
    void* receiver;
};

}  // namespace plumb
