// SPDX-License-Identifier: MIT
#include "house/rooms.h"

#include "catch.h"

using namespace plumb::test;
using Faults = std::vector<std::string>;

namespace {

std::vector<SourceFile> sourcesOfKit() {
    return sourcesUnder(repository / "kit/plumb", repository / "kit");
}

Ranks roomRanks() {
    return roomRanksIn(textOf(repository / "kit/plumb/dynamics/README.md"));
}

const Ranks twoRooms{{"id", 0}, {"values", 0}, {"bodies/", 1}, {"solver/", 2}, {"world", 3}};

}  // namespace

TEST_CASE("no room of dynamics includes one above or beside it in its README's table", "[house]") {
    const Ranks ranks = roomRanks();
    REQUIRE(ranks.size() > 10);
    CHECK(upwardRooms(ranks, sourcesOfKit()) == Faults{});
}

TEST_CASE("no unit of the kit includes itself by way of others", "[house]") {
    CHECK(unitsInRings(sourcesOfKit()) == Faults{});
}

TEST_CASE("only the world, its edits and its queries take the whole state of a world", "[house]") {
    CHECK(takersOfWholeWorlds({"world", "edit/", "query/"}, roomRanks(), sourcesOfKit()) == Faults{});
}

TEST_CASE("no folder, file or function of the kit is larger than a newcomer can take in", "[house]") {
    CHECK(tooLarge({}, sourcesOfKit()) == Faults{});
}

TEST_CASE("planted includes upward, sideways and out of the rooms' table are caught", "[house]") {
    const auto faults = [](const std::string& path, const std::string& text) {
        return upwardRooms(twoRooms, {{path, text}});
    };
    CHECK(faults("plumb/dynamics/bodies/a.cpp", "#include <plumb/dynamics/solver/b.h>\n").size() == 1);
    CHECK(faults("plumb/dynamics/id.h", "#include <plumb/dynamics/world.h>\n").size() == 1);
    CHECK(faults("plumb/dynamics/solver/a.cpp", "#include <plumb/dynamics/world_def.h>\n").size() == 1);
    CHECK(faults("plumb/dynamics/kitchen/a.cpp", "") == Faults{"`kitchen/` has no rank"});
    CHECK(faults("plumb/dynamics/solver/a.cpp",
                 "#include <plumb/dynamics/bodies/b.h>\n#include <plumb/math/vec2.h>\n") == Faults{});
    CHECK(faults("plumb/dynamics/world_step.cpp", "#include <plumb/dynamics/solver/a.h>\n") == Faults{});
    CHECK(upwardRooms({{"joints/", 1}, {"fields/", 1}},
                      {{"plumb/dynamics/joints/a.h", "#include <plumb/dynamics/fields/b.h>\n"}})
              .size() == 1);
}

TEST_CASE("a planted ring of units is caught, through header and source, and only the ring", "[house]") {
    const SourceFile aHeader{"plumb/math/a.h", ""}, aSource{"plumb/math/a.cpp", "#include <plumb/math/b.h>\n"};
    const SourceFile bHeader{"plumb/math/b.h", "#include <plumb/math/c.h>\n"};
    const SourceFile cSource{"plumb/math/c.cpp", "#include <plumb/math/a.h>\n"}, cHeader{"plumb/math/c.h", ""};
    const SourceFile user{"plumb/math/user.cpp", "#include <plumb/math/a.h>\n"};
    CHECK(unitsInRings({aHeader, aSource, bHeader, cHeader, cSource, user}) ==
          Faults{"plumb/math/a", "plumb/math/b", "plumb/math/c"});
    CHECK(unitsInRings({aHeader, aSource, bHeader, cHeader, user}) == Faults{});
}

TEST_CASE("a planted function that takes a whole world is caught", "[house]") {
    const auto faults = [](const std::string& path, const std::string& text) {
        return takersOfWholeWorlds({"world"}, twoRooms, {{path, text}});
    };
    CHECK(faults("plumb/dynamics/solver/a.h", "void solve(const WorldState& world);\n").size() == 1);
    CHECK(faults("plumb/dynamics/solver/a.h", "WorldState* world;\n").size() == 1);
    CHECK(faults("plumb/dynamics/solver/a.h", "struct WorldState {};\n") == Faults{});
    CHECK(faults("plumb/dynamics/world.cpp", "void solve(WorldState& world);\n") == Faults{});
}

TEST_CASE("a planted folder, file or function that is too large is caught", "[house]") {
    const Sizes small{.files = 1, .fileLines = 6, .functionLines = 2};
    CHECK(tooLarge(small, {{"plumb/math/a.h", ""}, {"plumb/math/b.h", ""}}).size() == 1);
    CHECK(tooLarge(small, {{"plumb/math/a.h", "\n\n\n\n\n\n\n"}}).size() == 1);
    CHECK(tooLarge(small, {{"plumb/math/a.cpp", "int f(int x) {\n    x;\n    x;\n    x;\n}\n"}}).size() == 1);
    CHECK(tooLarge(small, {{"plumb/math/a.cpp", "struct A {\n    int f() const {\n\n\n\n    }\n"}}).size() == 1);
    CHECK(tooLarge(small, {{"plumb/math/a.cpp", "int f(int x) {\n    x;\n    x;\n}\n"}}) == Faults{});
}

TEST_CASE("ranks of rooms are read from the table headed rank and rooms", "[house]") {
    CHECK(roomRanksIn("| rank | rooms | what |\n|---|---|---|\n| 0 | `id` · `lock` | `no` |\n| 1 | `bodies/` |  |\n\n"
                      "| 4 | `world` | |\n") == Ranks{{"id", 0}, {"lock", 0}, {"values", 0}, {"bodies/", 1}});
}
