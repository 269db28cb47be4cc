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

/// What so many cases have to come to at the least. A tenth of the cases may come to less than a tenth by chance: under
/// sanitizers half of that will do.
inline int leastOf(int all) {
    return shareOfCases == 10 ? all : allCases(all) / 2;
}

}  // namespace plumb::test
