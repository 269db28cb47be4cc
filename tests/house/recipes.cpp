// SPDX-License-Identifier: MIT
#include "house/recipes.h"

#include <sstream>

#include "house/blocks.h"

namespace plumb::test {

namespace {

/// A # begins a comment at the start of a word that is in no quotes.
std::string withoutShellComment(const std::string& line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '\'' || c == '"')
            quote = c;
        else if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
            return line.substr(0, i);
    }
    return line;
}

std::string withoutSpacesAround(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::vector<std::string> recipesOn(const std::string& page) {
    std::vector<std::string> commands;
    for (const Block& block : blocksOn(page)) {
        if (block.kind != "sh") continue;
        std::istringstream lines(block.text);
        std::string command;
        for (std::string line; std::getline(lines, line);) {
            command += withoutSpacesAround(withoutShellComment(line));
            if (command.ends_with('\\')) {
                command.pop_back();
                continue;
            }
            if (!command.empty()) commands.push_back(command);
            command.clear();
        }
    }
    return commands;
}

}  // namespace plumb::test
