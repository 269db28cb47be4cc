// SPDX-License-Identifier: MIT
// What does a command of the shell print, and how does it end?
#pragma once
#include <string>

namespace plumb::test {

struct Ran {
    bool ok = false;     ///< the exit status was 0
    std::string output;  ///< what went to standard output
};

Ran shell(const std::string& command);

/// For a command that is of interest only when it fails: then the test does, with all that was printed.
void mustRun(const std::string& command);

/// The text as one word of the shell.
std::string quoted(const std::string& text);

}  // namespace plumb::test
