// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "catch.h"
#include "house/cmake_project.h"
#include "house/shell.h"

using namespace plumb::test;

namespace {

std::string hashFrom(const std::string& compiler, const std::string& optimisation) {
    const auto build = houseFolder("bits") / (compiler + optimisation);
    buildProject({.source = std::string(PLUMB_SOURCE_DIR) + "/tests/bits",
                  .build = build,
                  .options = {"-DCMAKE_CXX_COMPILER=" + compiler, "-DCMAKE_BUILD_TYPE=Release",
                              "-DCMAKE_CXX_FLAGS_RELEASE=" + optimisation + " -DNDEBUG"}});
    const Ran ran = shell(quoted((build / "bits").string()));
    REQUIRE(ran.ok);
    return ran.output;
}

}  // namespace

TEST_CASE("GCC and Clang at -O1 and -O3 come to one state hash", "[house][build]") {
    const std::string reference = hashFrom("g++", "-O1");
    REQUIRE(std::count(reference.begin(), reference.end(), '\n') == 5);
    CHECK(hashFrom("g++", "-O3") == reference);
    CHECK(hashFrom("clang++", "-O1") == reference);
    CHECK(hashFrom("clang++", "-O3") == reference);
}
