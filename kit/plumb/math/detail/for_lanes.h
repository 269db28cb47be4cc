// SPDX-License-Identifier: MIT
// Which of several variants of a function, one for each number of lanes, should run on this machine?
#pragma once
#include <algorithm>
#include <cstddef>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// How many floats this machine processes at once: 4, 8 or 16; 1 where the compiler has no vector extensions.
inline int machineLanes() {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool has16 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                              __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    static const bool has8 = __builtin_cpu_supports("avx2");
    if (has16 && has8) return 16;
    return has8 ? 8 : 4;
#else
    return std::min(mostLanes, 4);
#endif
}

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
