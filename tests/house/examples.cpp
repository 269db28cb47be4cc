// SPDX-License-Identifier: MIT
#include "house/examples.h"

#include "house/blocks.h"

namespace plumb::test {

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
