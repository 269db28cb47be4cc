// SPDX-License-Identifier: MIT

#include <filesystem>
#include <fstream>

#include <games/frame/session.h>
#include <games/runner/level_text.h>
#include <games/runner/levels.h>

#include "catch.h"
#include "games/every_game.h"

using namespace plumb::games;
using namespace plumb::games::runner;

namespace {

GameInfo runnerInfo() {
    for (const GameInfo& info : plumb::test::everyGame())
        if (info.name == "runner") return info;
    FAIL("there is no game called runner");
    return {};
}

}  // namespace

TEST_CASE("a level of over 4 KB is read from a file unchanged", "[games][runner]") {
    const std::string file = (std::filesystem::temp_directory_path() / "plumb_runner_level.txt").string();
    const std::string text(builtInLevels().front().text);
    REQUIRE(text.size() > 4096);
    std::ofstream(file, std::ios::binary) << text;
    CHECK(levelIn(file).name == readLevel(text, "same").name);
    CHECK(levelIn(file).things.size() == readLevel(text, "same").things.size());
}

TEST_CASE("a missing level file and a folder are refused by name", "[games][runner]") {
    CHECK_THROWS_WITH(levelIn("/no/such/level.txt"), plumb::test::containsText("/no/such/level.txt: cannot be read"));
    CHECK_THROWS_WITH(levelIn("/tmp"), plumb::test::containsText("/tmp: cannot be read"));
}

TEST_CASE("a bad --level is refused before the title appears, not after Play", "[games][runner]") {
    SessionSetup setup;
    setup.options["level"] = "/no/such/level.txt";
    CHECK_THROWS_WITH(Session(runnerInfo(), setup), plumb::test::containsText("cannot be read"));
}
