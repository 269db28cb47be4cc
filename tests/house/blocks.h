// SPDX-License-Identifier: MIT
// Which fenced blocks stand on a page?
#pragma once
#include <string>
#include <vector>

namespace plumb::test {

struct Block {
    std::string kind;  ///< "cpp"; empty where the fence names none
    std::string text;
    bool follows = false;  ///< nothing but blank lines between the block before it and this
};

/// In their order; a fence may be indented, as within a list.
std::vector<Block> blocksOn(const std::string& page);

}  // namespace plumb::test
