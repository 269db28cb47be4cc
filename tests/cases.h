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

/// Has the environment PLUMB_FULL set to 1? `PLUMB_FULL=1 ./tests/run "[dynamics]"` goes through all cases.
inline bool isFull() {
    const char* full = std::getenv("PLUMB_FULL");
    return full && *full == '1';
}

/// All of them when all are wanted, else a tenth, and a hundredth under sanitizers.
inline int cases(int all) {
    return isFull() ? all : std::max(1, all / shareOfCases);
}

/// Of a test that takes seconds for each: so many every day that each kind of case is among them.
inline int seeds(int everyDay, int full) {
    return isFull() ? full : everyDay;
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
