// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "catch.h"
#include "games/walk_through.h"
#include "house/cmake_project.h"
#include "house/shell.h"

using namespace plumb::test;
namespace fs = std::filesystem;

namespace {

/// A copy of what the build reads, without the comparison.
void copyRepository(const fs::path& to) {
    const fs::path from = PLUMB_SOURCE_DIR;
    fs::remove_all(to);
    fs::create_directories(to);
    fs::copy(from / "CMakeLists.txt", to);
    for (const char* folder : {"kit", "games", "tests"})
        fs::copy(from / folder, to / folder, fs::copy_options::recursive);
}

}  // namespace

TEST_CASE("games/bounce, added as games/README.md says, does not clash with the copy that the tests build",
          "[games][build]") {
    const fs::path folder = houseFolder("new_game") / "plumb";
    copyRepository(folder);
    const WalkThrough page = walkThrough();
    const std::string name = page.line.substr(0, page.line.find(':'));
    // Whoever followed the page here has it already.
    if (fs::create_directories(folder / "games" / name)) {
        std::ofstream(folder / "games" / name / (name + ".cpp")) << page.source;
        std::ofstream(folder / "games" / "list.txt", std::ios::app) << page.line << '\n';
    }
    mustRun(quoted(PLUMB_CMAKE) + " -S " + quoted(folder.string()) + " -B " + quoted((folder / "build").string()) +
            " -G " + quoted(PLUMB_GENERATOR) + " -DCMAKE_CXX_COMPILER=" + quoted(PLUMB_COMPILER) +
            " -DPLUMB_BUILD_COMPARE=OFF");
}
