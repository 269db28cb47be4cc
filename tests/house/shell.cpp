// SPDX-License-Identifier: MIT
#include "house/shell.h"

#include <array>
#include <cstdio>
#include <stdexcept>

#include "catch.h"

namespace plumb::test {

Ran shell(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell for: " + command);
    Ran ran;
    std::array<char, 4096> chunk;
    for (std::size_t count; (count = std::fread(chunk.data(), 1, chunk.size(), pipe)) > 0;)
        ran.output.append(chunk.data(), count);
    ran.ok = pclose(pipe) == 0;
    return ran;
}

void mustRun(const std::string& command) {
    const Ran ran = shell(command + " 2>&1");
    if (!ran.ok) FAIL(command << "\n" << ran.output);
}

std::string quoted(const std::string& text) {
    std::string word = "'";
    for (const char c : text) {
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    }
    return word + "'";
}

}  // namespace plumb::test
