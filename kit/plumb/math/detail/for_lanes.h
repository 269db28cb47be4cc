// SPDX-License-Identifier: MIT
// Which of several variants of a function, one for each number of lanes, should run on this machine?
#pragma once
#include <algorithm>
#include <cstddef>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// The widest variant that the machine supports and that has at most the requested lanes. Not for use in files
/// ..._8.cpp and ..._16.cpp.
template <class Code>
const Code& forLanes(int lanes, const Code& one, const Code& four, const Code& eight, const Code& sixteen) {
    const int wanted = std::min(lanes, machineLanes());
    if (wanted >= 16) return sixteen;
    if (wanted >= 8) return eight;
    return wanted >= 4 ? four : one;
}

/// How many lanes to use for a few values: a wide operation takes as long for a few as for all.
inline int lanesFor(std::size_t values, int lanes) {
    return std::min(lanes, values <= 4 ? 4 : values <= 8 ? 8 : 16);
}

}  // namespace plumb
