// SPDX-License-Identifier: MIT
#include <games/frame/record.h>
#include <plumb/math/random.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "catch.h"
#include "games/every_game.h"
#include "house/bits_build.h"
#include "house/cmake_project.h"
#include "house/shell.h"

using namespace plumb;
using namespace plumb::games;
namespace fs = std::filesystem;

namespace {

/// A record of a session that the computer plays, if it can, with a random extra button now and then.
Record recordOf(const GameInfo& info, std::uint64_t seed, int ticks) {
    Session session(info, {.seed = seed});
    const auto computer = info.computer ? computerSource(info) : nullptr;
    Random random(seed);
    Record record{info.name, seed};
    for (int tick = 0; tick < ticks; ++tick) {
        Buttons buttons = computer ? computer->next(session).value_or(0) : 0;
        if (random.integer(0, 100) == 0) buttons ^= Buttons{1} << random.integer(0, session.actions().size() - 1);
        session.update(buttons);
        record.add(buttons);
    }
    record.hash = session.hash();
    return record;
}

void write(const fs::path& file, const Record& record, const GameInfo& info) {
    std::ofstream out(file);
    out << textOf(record, withMenuActions(info.actions));
    REQUIRE(out.good());
}

}  // namespace

TEST_CASE("records of 5000 ticks from this build replay to the same hash in a build by Clang at -O1",
          "[games][build]") {
    const fs::path programs = test::buildBits("clang++", "-O1") / "plumb" / "bin",
                   folder = test::houseFolder("records");
    fs::create_directories(folder);
    for (const GameInfo& info : allGames())
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Record record = recordOf(info, seed, 5000);
            const fs::path file = folder / (info.name + std::to_string(seed) + ".record");
            write(file, record, info);
            const test::Ran ran = test::shell(test::quoted((programs / ("plumb-" + info.name)).string()) +
                                              " --headless --replay " + test::quoted(file.string()));
            CAPTURE(info.name, seed, ran.output);
            REQUIRE(ran.ok);
            const auto told = nlohmann::json::parse(ran.output);
            CHECK(told["hash"] == fmt::format("{:016x}", *record.hash));
            CHECK(told["ticks"] == 5000);
        }
}
