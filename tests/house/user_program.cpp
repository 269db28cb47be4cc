// SPDX-License-Identifier: MIT
#include "house/user_program.h"

#include <filesystem>
#include <fstream>

#include "house/cmake_project.h"
#include "house/repository.h"

namespace plumb::test {

namespace {

/// Writes the program, and returns the command that compiles it, as the package's options have it.
std::string commandFor(const std::string& compiler, const std::string& options, const std::string& program) {
    const std::filesystem::path folder = houseFolder("user_program");
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "main.cpp") << program;
    return "cd " + quoted(folder.string()) + " && " + compiler + " -std=c++20 -ffp-contract=off -I" +
           quoted((repository / "kit").string()) + " " + options + " main.cpp";
}

}  // namespace

Ran compiled(const std::string& compiler, const std::string& options, const std::string& program) {
    return shell(commandFor(compiler, options, program) + " 2>&1");
}

Ran builtAndRun(const std::string& compiler, const std::string& options, const std::string& program) {
    const std::string library = quoted((std::filesystem::path(PLUMB_BUILD_DIR) / "kit/libplumb.a").string());
    mustRun(commandFor(compiler, options, program) + " " + library + " -o program");
    return shell(quoted((houseFolder("user_program") / "program").string()) + " 2>&1");
}

}  // namespace plumb::test
