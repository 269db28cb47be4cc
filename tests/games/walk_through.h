// SPDX-License-Identifier: MIT
// Which source and which line of games/README.md make a new game?
#pragma once
#include <fstream>
#include <iterator>
#include <string>

namespace plumb::test {

struct WalkThrough {
    std::string source;  ///< the first block of C++ on the page
    std::string line;    ///< for games/list.txt, without the line end
};

inline WalkThrough walkThrough() {
    std::ifstream in(PLUMB_SOURCE_DIR "/games/README.md");
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    const auto between = [&](const std::string& before, const std::string& after) {
        const std::size_t begin = page.find(before) + before.size();
        return page.substr(begin, page.find(after, begin) - begin);
    };
    return {between("```cpp\n", "```"), between("`games/list.txt`:\n\n```\n", "\n```")};
}

}  // namespace plumb::test
