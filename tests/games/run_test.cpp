// SPDX-License-Identifier: MIT

#include <filesystem>

#include <games/all_games.h>

#include "catch.h"
#include "house/shell.h"

using namespace plumb;
using namespace plumb::test;

namespace {

Ran run(const std::string& arguments) {
    return shell(quoted(PLUMB_SOURCE_DIR "/games/run") + " " + arguments);
}

}  // namespace

TEST_CASE("games/run --help and -h print the same as games/run alone: the usage and a line for each game", "[games]") {
    const Ran alone = run("");
    REQUIRE(alone.ok);
    CHECK_THAT(alone.output, containsText("games/run NAME [ARGS]"));
    for (const games::GameInfo& info : games::allGames()) CHECK_THAT(alone.output, containsText("  " + info.name));
    for (const char* arguments : {"--help", "-h", "pictures --help", "pictures -h"}) {
        CAPTURE(arguments);
        const Ran help = run(arguments);
        CHECK(help.ok);
        CHECK(help.output == alone.output);
    }
}

TEST_CASE("games/run with an unknown name lists the names of the games and ends with status 2", "[games]") {
    const Ran ran = run("tennis 2>&1; echo $?");
    CHECK_THAT(ran.output, containsText("there is no game \"tennis\""));
    for (const games::GameInfo& info : games::allGames()) CHECK_THAT(ran.output, containsText(" " + info.name));
    CHECK(ran.output.ends_with("\n2\n"));
}

TEST_CASE("games/run web refuses a port that is none, before it builds", "[games]") {
    for (const std::string port : {"99999", "8o80", "-1", "''"}) {
        INFO(port);
        const Ran ran = run("web --port " + port + " 2>&1; echo $?");
        CHECK_THAT(ran.output, containsText("a number up to 65526 was wanted"));
        CHECK(ran.output.ends_with("\n2\n"));
    }
}

TEST_CASE("before the first build games/run maze --help shows the page's examples, and builds nothing", "[games]") {
    namespace fs = std::filesystem;
    const fs::path source = PLUMB_SOURCE_DIR, folder = fs::temp_directory_path() / "unbuilt";
    fs::remove_all(folder);
    fs::create_directories(folder / "games" / "maze");
    for (const fs::path file : {"games/run", "games/list.txt", "games/maze/README.md"})
        fs::copy_file(source / file, folder / file);
    for (const char* question : {"--help", "-h", "--seed 3 --help"}) {
        const Ran help = shell(quoted((folder / "games/run").string()) + " maze " + question);
        CHECK(help.ok);
        CHECK_THAT(help.output, containsText("maze: four cats") && containsText("./games/run maze --level 5"));
    }
    CHECK_FALSE(fs::exists(folder / "build"));
}
