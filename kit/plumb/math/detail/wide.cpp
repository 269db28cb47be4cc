// SPDX-License-Identifier: MIT
#include <plumb/math/detail/wide.h>

#include <algorithm>

namespace plumb {

int machineLanes() {
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

}  // namespace plumb
