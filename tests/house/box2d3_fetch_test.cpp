// SPDX-License-Identifier: MIT
// Does the comparison get Box2D 3 by itself, and go on without it where it cannot be had?
#include <filesystem>
#include <fstream>
#include <string>

#include "catch.h"
#include "house/cmake_project.h"
#include "house/repository.h"
#include "house/shell.h"

using namespace plumb::test;

namespace fs = std::filesystem;

namespace {

/// What CMake says when it configures the comparison with these options.
Ran configureComparison(const fs::path& build, const std::string& options) {
    return shell("env -u PLUMB_BOX2D3_DIR -u PLUMB_BOX2D3_GIT -u PLUMB_FETCH_BOX2D3 " + quoted(PLUMB_CMAKE) + " -S " +
                 quoted(repository.string()) + " -B " + quoted(build.string()) + " -G " + quoted(PLUMB_GENERATOR) +
                 " -DPLUMB_BUILD_TESTS=OFF -DPLUMB_BUILD_GAMES=OFF -DPLUMB_FETCH_BOX2D3=ON " + options + " 2>&1");
}

fs::path freshFolder(const std::string& name) {
    const fs::path folder = houseFolder(name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

bool says(const Ran& ran, const std::string& text) {
    return ran.output.find(text) != std::string::npos;
}

// What is called box2d 3.2 and installs as it does.
constexpr const char* standIn = R"(cmake_minimum_required(VERSION 3.22)
project(box2d VERSION 3.2.0 LANGUAGES C)
file(WRITE "${CMAKE_BINARY_DIR}/b2.c" "int b2(void) { return BOX2D_BUILT; }")
add_library(box2d STATIC "${CMAKE_BINARY_DIR}/b2.c")
target_compile_definitions(box2d PRIVATE BOX2D_BUILT=1)
install(TARGETS box2d EXPORT box2dConfig ARCHIVE DESTINATION lib)
install(EXPORT box2dConfig NAMESPACE box2d:: DESTINATION lib/cmake/box2d)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(box2dConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_BINARY_DIR}/box2dConfigVersion.cmake" DESTINATION lib/cmake/box2d)
)";

}  // namespace

TEST_CASE("where Box2D 3 cannot be fetched, the comparison is made without it, and a line says so",
          "[house][build][compare]") {
    const fs::path folder = freshFolder("box2d3_nowhere");
    const Ran ran = configureComparison(folder / "build", "-DPLUMB_BOX2D3_GIT=" + quoted((folder / "none").string()));
    INFO(ran.output);
    CHECK(ran.ok);
    CHECK(says(ran, "Box2D 3: not found, the comparison runs without it"));
}

TEST_CASE("Box2D 3 is fetched from a mirror, built and found, once", "[house][build][compare]") {
    const fs::path folder = freshFolder("box2d3_mirror"), mirror = folder / "mirror";
    fs::create_directories(mirror);
    std::ofstream(mirror / "CMakeLists.txt") << standIn;
    const std::string git = "git -C " + quoted(mirror.string()) + " -c user.name=a -c user.email=a@b.c ";
    mustRun(git + "init -q && " + git + "add . && " + git + "commit -q -m one");
    const std::string commit = shell(git + "rev-parse HEAD").output.substr(0, 40);
    const std::string options = "-DPLUMB_BOX2D3_GIT=" + quoted(mirror.string()) + " -DPLUMB_BOX2D3_COMMIT=" + commit;
    const Ran first = configureComparison(folder / "build", options);
    INFO(first.output);
    CHECK(first.ok);
    CHECK(says(first, "Box2D 3: fetching " + commit.substr(0, 8)));
    CHECK(says(first, "Box2D 3: 3.2.0 in "));
    const Ran second = configureComparison(folder / "build", options);
    CHECK(says(second, "Box2D 3: 3.2.0 in "));
    CHECK_FALSE(says(second, "fetching"));
}
