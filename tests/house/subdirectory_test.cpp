// SPDX-License-Identifier: MIT
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "catch.h"
#include "house/cmake_project.h"
#include "house/compile_commands.h"
#include "house/repository.h"
#include "house/ten_lines.h"

using namespace plumb::test;

namespace {

/// The project of a user who has Plumb as a subdirectory, as add_subdirectory and FetchContent make it.
CmakeProject userProject(const std::string& folder, std::vector<std::string> options = {}) {
    options.push_back(std::string("-DCMAKE_CXX_COMPILER=") + PLUMB_COMPILER);
    options.push_back("-DCMAKE_EXPORT_COMPILE_COMMANDS=ON");
    options.push_back("-DPLUMB_FOLDER=" + repository.string());
    return {.source = repository / "tests/install", .build = houseFolder(folder), .options = options};
}

struct UserBuild {
    CompileCommand own;               ///< of the user's one source
    std::vector<CompileCommand> kit;  ///< of all that is Plumb's
};

UserBuild configured(const CmakeProject& project) {
    configureProject(project);
    UserBuild build;
    for (const CompileCommand& each : compileCommandsIn(project.build)) {
        if (each.file.ends_with("/kit/example/main.cpp"))
            build.own = each;
        else
            build.kit.push_back(each);
    }
    REQUIRE_FALSE(build.own.command.empty());
    REQUIRE(build.kit.size() > 5);
    return build;
}

void checkKitIsFast(const UserBuild& build) {
    for (const CompileCommand& each : build.kit) {
        CAPTURE(each.file, each.command);
        CHECK(std::set<std::string>{"-O2", "-O3", "-Os"}.contains(each.optimisation()));
        CHECK(each.has("-DNDEBUG"));
        CHECK_FALSE(each.has("-Werror"));
    }
}

void checkOwnIsAsTheUserHasIt(const UserBuild& build) {
    CAPTURE(build.own.command);
    CHECK(build.own.optimisation().empty());
    CHECK_FALSE(build.own.has("-DNDEBUG"));
}

}  // namespace

TEST_CASE("as a subdirectory the kit is optimised whatever the user's build type, and the user's own sources are not",
          "[house][build]") {
    const UserBuild plain = configured(userProject("no_build_type"));
    checkKitIsFast(plain);
    checkOwnIsAsTheUserHasIt(plain);

    std::filesystem::remove_all(houseFolder("build_types"));  // options stay in a folder
    const UserBuild debug = configured(userProject("build_types", {"-DCMAKE_BUILD_TYPE=Debug"}));
    checkKitIsFast(debug);
    checkOwnIsAsTheUserHasIt(debug);
    checkKitIsFast(configured(userProject("build_types", {"-DCMAKE_BUILD_TYPE=Release"})));

    const UserBuild asked =
        configured(userProject("build_types", {"-DCMAKE_BUILD_TYPE=Debug", "-DPLUMB_OPTIMISE=OFF"}));
    for (const CompileCommand& each : asked.kit) {
        CAPTURE(each.file, each.command);
        CHECK(each.optimisation().empty());
        CHECK_FALSE(each.has("-DNDEBUG"));
    }
}

// About 100 seconds of one processor, from nothing.
TEST_CASE("the ten-line program, built with Plumb as a subdirectory and no build type, prints a ball at rest at y = 1",
          "[house][build]") {
    const CmakeProject project = userProject("no_build_type");
    buildProject(project);
    requireBallAtRest(project.build / "falling_ball");
}

TEST_CASE("a warning stops no build of somebody who has not asked for that", "[house][build]") {
    CmakeProject project{
        .source = repository,
        .build = houseFolder("warnings"),
        .options = {std::string("-DCMAKE_CXX_COMPILER=") + PLUMB_COMPILER, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"}};
    std::filesystem::remove_all(project.build);
    configureProject(project);
    for (const CompileCommand& each : compileCommandsIn(project.build)) {
        CAPTURE(each.file, each.command);
        CHECK_FALSE(each.has("-Werror"));
    }
    project.options.push_back("-DPLUMB_WARNINGS_AS_ERRORS=ON");
    configureProject(project);
    for (const CompileCommand& each : compileCommandsIn(project.build)) {
        CAPTURE(each.file, each.command);
        CHECK(each.has("-Werror"));
    }
}
