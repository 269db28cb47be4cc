// SPDX-License-Identifier: MIT
#include "house/blocks.h"

#include <algorithm>
#include <sstream>

namespace plumb::test {

std::vector<Block> blocksOn(const std::string& page) {
    std::vector<Block> blocks;
    std::istringstream lines(page);
    std::string line;
    bool inside = false, blank = false;
    while (std::getline(lines, line)) {
        const std::size_t fence = std::min(line.find_first_not_of(' '), line.size());
        if (line.compare(fence, 3, "```") == 0) {
            inside = !inside;
            if (inside) blocks.push_back({line.substr(fence + 3), "", blank});
            blank = !inside;
        } else if (inside) {
            blocks.back().text += line + "\n";
        } else if (!line.empty()) {
            blank = false;
        }
    }
    return blocks;
}

}  // namespace plumb::test
