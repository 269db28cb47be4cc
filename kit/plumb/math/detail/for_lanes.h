// SPDX-License-Identifier: MIT
// Which of several codes, one for each number of lanes, is this machine to run?
#pragma once
#include <algorithm>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// The widest that it can, and that has no more than the lanes asked for. Not for files of ..._8.cpp and ..._16.cpp.
template <class Code>
const Code& forLanes(int lanes, const Code& one, const Code& four, const Code& eight, const Code& sixteen) {
    const int wanted = std::min(lanes, machineLanes());
    if (wanted >= 16) return sixteen;
    if (wanted >= 8) return eight;
    return wanted >= 4 ? four : one;
}

}  // namespace plumb
