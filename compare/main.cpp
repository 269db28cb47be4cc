// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include <compare/command/command.h>

int main(int argc, char** argv) {
    const std::vector<std::string> args(argv + 1, argv + argc);
    const bool colour = isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR");
    return plumb::compare::runCommand(args, std::cout, std::cerr, colour);
}
