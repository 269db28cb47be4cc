// SPDX-License-Identifier: MIT
// How many seeded cases does a property run through?
#pragma once
#include <algorithm>
#include <cstdlib>

namespace plumb::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/// Sanitizers look at each line that runs, and take ten times as long: few cases run all lines.
inline constexpr int shareOfCases = 100;
#else
inline constexpr int shareOfCases = 10;
#endif

/// All of them when the environment has PLUMB_FULL set to 1, else a tenth, and a hundredth under sanitizers.
inline int cases(int all) {
    const char* full = std::getenv("PLUMB_FULL");
    return full && *full == '1' ? all : std::max(1, all / shareOfCases);
}

/// Of a property that runs through all of them always: a tenth under sanitizers.
inline int allCases(int all) {
    return std::max(1, 10 * all / shareOfCases);
}

}  // namespace plumb::test
