// SPDX-License-Identifier: MIT
// How many seeds does a test go through that takes seconds for each?
#pragma once
#include "cases.h"

namespace plumb::test {

/// So many that each kind of case is among them, and all with PLUMB_FULL=1 in the environment:
/// `PLUMB_FULL=1 ./tests/run "[dynamics]"`.
inline int seeds(int everyDay, int full) {
    const bool allWanted = cases(shareOfCases) == shareOfCases;  // else it is one of them
    return allWanted ? full : everyDay;
}

}  // namespace plumb::test
