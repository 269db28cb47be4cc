// SPDX-License-Identifier: MIT
#include "house/examples.h"

#include <sstream>

namespace plumb::test {

namespace {

struct Block {
    std::string kind;  ///< "cpp"
    std::string text;
    bool follows = false;  ///< nothing but blank lines between the block before it and this
};

std::vector<Block> blocksOn(const std::string& page) {
    std::vector<Block> blocks;
    std::istringstream lines(page);
    std::string line;
    bool inside = false, blank = false;
    while (std::getline(lines, line)) {
        if (line.rfind("```", 0) == 0) {
            inside = !inside;
            if (inside) blocks.push_back({line.substr(3), "", blank});
            blank = !inside;
        } else if (inside) {
            blocks.back().text += line + "\n";
        } else if (!line.empty()) {
            blank = false;
        }
    }
    return blocks;
}

}  // namespace

std::vector<Example> examplesOn(const std::string& page) {
    std::vector<Example> examples;
    bool open = false;
    for (const Block& block : blocksOn(page)) {
        const bool program = block.kind == "cpp" && block.text.find("int main()") != std::string::npos;
        if (program) examples.push_back({block.text, ""});
        if (open && block.kind == "text" && block.follows) examples.back().output = block.text;
        open = program;
    }
    return examples;
}

}  // namespace plumb::test
