// SPDX-License-Identifier: MIT
#include <games/frame/record.h>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "games/counting_game.h"

using namespace plumb;
using namespace plumb::games;
using test::containsText;

namespace {

Record read(const std::string& text) {
    return readRecord(text, "a.record", test::countingGame());
}

const std::string head = "plumb-record 1 counting\n";

}  // namespace

TEST_CASE("random records of 1 to 300 ticks read back as they were written", "[games]") {
    const ActionList actions = withMenuActions(test::countingGame().actions);
    Random random(3);
    for (int i = 0; i < test::cases(1000); ++i) {
        Record record{"counting", random.bits(), {{"strength", "strong"}}};
        for (int tick = random.integer(1, 300); tick > 0; --tick)
            record.add(static_cast<Buttons>(random.integer(0, (1 << actions.size()) - 1)) & Buttons(random.bits()));
        if (random.integer(0, 1) == 1) record.hash = random.bits();
        const Record back = read(textOf(record, actions));
        REQUIRE(back.seed == record.seed);
        REQUIRE(back.options == record.options);
        REQUIRE(back.runs == record.runs);
        REQUIRE(back.hash == record.hash);
    }
}

TEST_CASE("a record written by hand, with comments and empty lines, is played as it says", "[games]") {
    Record record = read(head + "seed 7\n\n# the title\n2 -\n1 confirm  # start\n3 hit+left\n");
    CHECK(record.ticks() == 6);
    const auto source = recordSource(record);
    const Session session(test::countingGame(), {});
    std::vector<Buttons> played;
    while (const auto buttons = source->next(session)) played.push_back(*buttons);
    const Buttons confirm = session.actions().button("confirm"), both = 1 | session.actions().button("left");
    CHECK(played == std::vector<Buttons>{0, 0, confirm, both, both, both});
}

TEST_CASE("an option's value goes to the end of its line: a file may be called \"#1 my option level.txt\"", "[games]") {
    const std::string file = "#1 my option level.txt";
    Record record{"counting", 1, {{"level", file}}};
    const std::string text = textOf(record, withMenuActions(test::countingGame().actions));
    CHECK(read(text).options.at("level") == file);
    CHECK(read(head + "  option\tlevel   a b \r\n").options.at("level") == "a b");
}

TEST_CASE("a broken record is refused with the line number, the text of the line and what was expected", "[games]") {
    CHECK_THROWS_WITH(read(""), containsText("a.record:1: \"\" is not \"plumb-record 1 counting\""));
    CHECK_THROWS_WITH(read("plumb-record 1 maze\n"), containsText("a.record:1") && containsText("counting"));
    CHECK_THROWS_WITH(read("plumb-record 2 counting\n"), containsText("a.record:1"));
    CHECK_THROWS_WITH(read("\x89PNG\r\n\x1a\n"), containsText("a.record:1: \"?PNG?\""));
    CHECK_THROWS_WITH(read(head + "seed -1\n"), containsText("a.record:2: \"seed -1\" is not"));
    CHECK_THROWS_WITH(read(head + "seed 18446744073709551616\n"), containsText("a.record:2"));
    CHECK_THROWS_WITH(read(head + "option strength\n"), containsText("its name and its value"));
    CHECK_THROWS_WITH(read(head + "# one\n3 -\n0 -\n"), containsText("a.record:4: \"0 -\" is not a number of ticks"));
    CHECK_THROWS_WITH(read(head + "-3 hit\n"), containsText("a number of ticks"));
    CHECK_THROWS_WITH(read(head + "9999999999 hit\n"), containsText("1 to 10^9"));
    CHECK_THROWS_WITH(read(head + "3\n"), containsText("the actions done in them"));
    CHECK_THROWS_WITH(read(head + "3 fly\n"), containsText("the actions of counting: hit, give-up, confirm"));
    CHECK_THROWS_WITH(read(head + "3 hit\n3 hit+\n"), containsText("a.record:3"));
    CHECK_THROWS_WITH(read(head + "end xyz\n"), containsText("hexadecimal"));
    CHECK_THROWS_WITH(read(head + "end 12\n1 -\n"), containsText("a.record:3") && containsText("after"));
}

TEST_CASE("the seeds 0 and 2^64 - 1 are accepted", "[games]") {
    CHECK(read(head + "seed 0\n").seed == 0);
    CHECK(read(head + "seed 18446744073709551615\n").seed == 18446744073709551615u);
}
