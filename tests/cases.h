// SPDX-License-Identifier: MIT
// How many seeded cases does a property run through?
#pragma once
#include <cstdlib>

namespace plumb::test {

/// All of them when the environment has PLUMB_FULL set to 1, else a tenth.
inline int cases(int all) {
    const char* full = std::getenv("PLUMB_FULL");
    return full && *full == '1' ? all : all / 10;
}

}  // namespace plumb::test
