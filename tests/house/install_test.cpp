// SPDX-License-Identifier: MIT
#include <filesystem>
#include <sstream>
#include <string>

#include "catch.h"
#include "house/cmake_project.h"
#include "house/shell.h"

using namespace plumb::test;
namespace fs = std::filesystem;

namespace {

const std::string sourceFolder = PLUMB_SOURCE_DIR;
const std::string compiler = std::string("-DCMAKE_CXX_COMPILER=") + PLUMB_COMPILER;

// Radius 0.5 on a ground whose top is at 0.5. Contacts are soft: at rest they give by less than a millimetre.
void requireBallAtRest(const fs::path& program) {
    const Ran ran = shell(quoted(program.string()));
    INFO(ran.output);
    REQUIRE(ran.ok);
    double x = -1, y = -1;
    std::istringstream(ran.output) >> x >> y;
    CHECK(x == 0);
    CHECK_THAT(y, Catch::Matchers::WithinAbs(1, 1e-3));
}

}  // namespace

TEST_CASE("the ten-line program, built with an installation, prints a ball at rest at y = 1", "[house][build]") {
    const fs::path folder = houseFolder("installed");
    fs::remove_all(folder);  // what an installation leaves out must not be there from an earlier one
    const std::string prefix = (folder / "prefix").string();
    mustRun(quoted(PLUMB_CMAKE) + " --install " + quoted(PLUMB_BUILD_DIR) + " --prefix " + quoted(prefix));
    for (const auto& entry : fs::recursive_directory_iterator(prefix)) CHECK(entry.path().filename() != "detail");

    buildProject({.source = sourceFolder + "/tests/install",
                  .build = folder / "build",
                  .options = {compiler, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_PREFIX_PATH=" + prefix}});
    requireBallAtRest(folder / "build" / "falling_ball");
}

TEST_CASE("the ten-line program, built with Plumb as a subdirectory, prints a ball at rest at y = 1",
          "[house][build]") {
    const fs::path build = houseFolder("subdirectory");
    buildProject({.source = sourceFolder + "/tests/install",
                  .build = build,
                  .options = {compiler, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                              "-DPLUMB_FOLDER=" + sourceFolder}});
    requireBallAtRest(build / "falling_ball");
}
