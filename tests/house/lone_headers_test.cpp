// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "catch.h"
#include "house/arrows.h"
#include "house/cmake_project.h"
#include "house/compile_commands.h"
#include "house/repository.h"
#include "house/shell.h"

using namespace plumb::test;

namespace {

/// A user's compiler and options, up to where source and result are named.
std::string userCompiler(const CmakeProject& project) {
    configureProject(project);
    for (const CompileCommand& each : compileCommandsIn(project.build))
        if (each.file.ends_with("/kit/example/main.cpp")) return each.command.substr(0, each.command.find(" -o "));
    FAIL("no command for kit/example/main.cpp");
    return "";
}

/// One source for each header that is installed, which includes nothing else; returns how many.
int writeLoneSources(const std::filesystem::path& folder) {
    int count = 0;
    for (const auto& file : repositoryFiles()) {
        const std::string path = file.generic_string();
        if (!path.starts_with("kit/") || !isInstalled(path.substr(sizeof("kit/") - 1))) continue;
        std::string name = path.substr(sizeof("kit/plumb/") - 1);
        std::replace(name.begin(), name.end(), '/', '_');
        std::ofstream(folder / (name + ".cpp")) << "#include <" << path.substr(sizeof("kit/") - 1) << ">\n";
        ++count;
    }
    return count;
}

}  // namespace

// 50 seconds of one processor, because Clang reads Eigen but once. What a header needs of the standard library, and has
// from Eigen here, is read from its text (header_names_test.cpp).
TEST_CASE("every header that is installed compiles alone, and without a warning", "[house][build]") {
    const std::filesystem::path folder = houseFolder("lone_headers");
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "sources");
    const std::string compiler =
        userCompiler({.source = repository / "tests/install",
                      .build = folder / "user",
                      .options = {"-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                                  "-DPLUMB_FOLDER=" + repository.string()}});
    REQUIRE(writeLoneSources(folder / "sources") > 100);
    std::ofstream(folder / "eigen.h") << "#include <Eigen/Core>\n";
    const std::string enter = "cd " + quoted(folder.string()) + " && ";
    mustRun(enter + compiler + " -x c++-header eigen.h -o eigen.pch");
    mustRun(enter + "ls sources/*.cpp | xargs -n 1 -P " +
            std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " " + compiler +
            " -fsyntax-only -include-pch eigen.pch");
}
