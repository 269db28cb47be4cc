// SPDX-License-Identifier: MIT
// Which programs stand on a page, and what does it say that they print?
#pragma once
#include <string>
#include <vector>

namespace plumb::test {

struct Example {
    std::string program;  ///< the text of a block ```cpp that has a main()
    std::string output;   ///< of the block ```text right after it; empty where there is none
};

std::vector<Example> examplesOn(const std::string& page);

}  // namespace plumb::test
