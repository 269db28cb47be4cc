// SPDX-License-Identifier: MIT
#include "catch.h"
#include "house/cmake_project.h"
#include "house/repository.h"
#include "house/ten_lines.h"

using namespace plumb::test;

TEST_CASE("the ten-line program, built with Plumb as a subdirectory, prints a ball at rest at y = 1",
          "[house][build]") {
    const std::filesystem::path build = houseFolder("subdirectory");
    buildProject(
        {.source = repositoryFolder() / "tests/install",
         .build = build,
         .options = {std::string("-DCMAKE_CXX_COMPILER=") + PLUMB_COMPILER, "-DCMAKE_BUILD_TYPE=Release",
                     "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DPLUMB_FOLDER=" + repositoryFolder().string()}});
    requireBallAtRest(build / "falling_ball");
}
