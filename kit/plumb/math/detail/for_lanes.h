// SPDX-License-Identifier: MIT
// Which of several variants of a function, one for each number of lanes, should run on this machine?
#pragma once
#include <algorithm>
#include <cstddef>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// pick.operator()<W>() for the widest variant W that the machine supports and that has at most the requested lanes;
/// for the narrowest that there is, if all have more. Not for use in files ..._8.cpp and ..._16.cpp.
template <class Pick>
decltype(auto) forLanes(int lanes, Pick&& pick) {
    const int wanted = std::min(lanes, machineLanes());
    if constexpr (mostLanes >= 16) {
        if (wanted >= 16) return pick.template operator()<16>();
        if (wanted >= 8) return pick.template operator()<8>();
    }
    if constexpr (mostLanes >= 4)
        if (wanted >= 4 || fewestLanes == 4) return pick.template operator()<4>();
    if constexpr (fewestLanes == 1) return pick.template operator()<1>();
}

/// How many lanes to use for a few values: a wide operation takes as long for a few as for all.
inline int lanesFor(std::size_t values, int lanes) {
    return std::min(lanes, values <= 4 ? 4 : values <= 8 ? 8 : 16);
}

}  // namespace plumb
