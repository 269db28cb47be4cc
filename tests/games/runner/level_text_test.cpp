// SPDX-License-Identifier: MIT
#include <games/runner/level_text.h>

#include <games/runner/levels.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::games::runner;
using plumb::test::containsText;

namespace {

/// A level of these rows; the first is row 2 of the text.
Level levelOf(const std::string& rows) {
    return readLevel("map:\n" + rows, "mine.txt");
}

}  // namespace

TEST_CASE("a level's text gives tiles, things, start, beacon and a lift with its path", "[games][runner]") {
    const Level level =
        readLevel("; a note\nname: Hill\nsky: night\npar: 42\nmap:\n..o..\n.pp--\nS...G\n##/^~\n", "hill.txt");
    CHECK(level.name == "Hill");
    CHECK(level.sky == Sky::Night);
    CHECK(level.par == 42);
    CHECK(level.tiles.rows() == 4);
    CHECK(level.start == Vec2(0.5, 1.5));
    CHECK(level.beacon == Vec2(4.5, 1.5));
    CHECK(level.tiles.at({2, 0}).form == TileForm::SlopeUp);
    CHECK(level.tiles.at({3, 0}).kind == TileKind::Hazard);
    CHECK(level.tiles.at({4, 0}).kind == TileKind::Sensor);
    REQUIRE(level.things.size() == 1);
    CHECK(level.things[0].at == Vec2(2.5, 3.5));
    REQUIRE(level.platforms.size() == 1);
    // A lift of two letters: its middle is between two cells, half a metre to the right of a cell's; so is its path.
    CHECK(level.platforms[0].width == 2);
    CHECK(level.platforms[0].path.at(0).position == Vec2(2, 2.5));
    CHECK(level.platforms[0].path.end() == Vec2(5, 2.5));
    CHECK(level.platforms[0].repeat == PathRepeat::BackAndForth);
}

TEST_CASE("a track that returns to its lift is a loop of 12 m", "[games][runner]") {
    const Level level = levelOf("+---+\n|...|\n+-p-+\nS...G\n");
    REQUIRE(level.platforms.size() == 1);
    CHECK(level.platforms[0].repeat == PathRepeat::Loop);
    CHECK(level.platforms[0].path.length() == 12);
}

TEST_CASE("a bad level is refused with file, row, column and what was wanted", "[games][runner]") {
    const auto refusal = [](const std::string& text, const std::string& expected) {
        INFO(expected);
        REQUIRE_THROWS_WITH(readLevel(text, "mine.txt"), containsText(expected));
    };
    refusal("map:\nS..G\n##q#\n", "mine.txt:3:3: 'q' stands for nothing; wanted was one of ");
    refusal("map:\nS..G\n##\t#\n", "mine.txt:3:3: byte 9 stands for nothing");
    refusal("map:\n...G\n####\n", "mine.txt:2:1: no start: one S was wanted");
    refusal("map:\nS...\n####\n", "mine.txt:2:1: no beacon: one G was wanted");
    refusal("map:\nS.SG\n####\n", "mine.txt:2:3: a second S: one was wanted");
    refusal("map:\nS..GG\n####\n", "mine.txt:2:5: a second G: one was wanted");
    refusal("map:\nS.pG\n####\n", "mine.txt:2:3: a platform without a track: one of -, | or + was wanted");
    refusal("map:\nS.-G\n####\n", "mine.txt:2:3: a track without a platform");
    refusal("map:\n..|..\np-+-.\nS.|.G\n", "mine.txt:3:3: a track that forks");
    refusal("map:\n", "mine.txt:2:1: no map: its rows were wanted here");
    refusal("name: x\n", "mine.txt:2:1: the text ends: a line \"map:\" and the map were wanted");
    refusal("", "mine.txt:1:1: the text ends");
    refusal("colour: red\nmap:\nSG\n", "mine.txt:1:1: \"colour\": one of name:, sky:, par: and map: was wanted");
    refusal("name: x\nsky:  pink\nmap:\nSG\n", "mine.txt:2:7: \"pink\": a sky of dawn, noon or night was wanted");
    refusal("par: 0\nmap:\nSG\n", "mine.txt:1:6: \"0\": whole seconds from 1 to 3600 were wanted");
    refusal("par: 12s\nmap:\nSG\n", "mine.txt:1:6: \"12s\": whole seconds");
    refusal("map:\nSG" + std::string(999, '.') + "\n", "mine.txt:2:1001: a row too long");
    std::string tall = "map:\n";
    for (int row = 0; row < 101; ++row) tall += "SG\n";
    refusal(tall, "mine.txt:102:1: a row too many");
}

TEST_CASE("each of the three levels has its beacon, three suns, checkpoints and coins", "[games][runner]") {
    REQUIRE(builtInLevels().size() == 3);
    for (const LevelText& text : builtInLevels()) {
        INFO(text.file);
        const Level level = readLevel(text.text, text.file);
        const auto count = [&](ThingKind kind) {
            int number = 0;
            for (const Thing& thing : level.things) number += thing.kind == kind ? 1 : 0;
            return number;
        };
        CHECK(count(ThingKind::Sun) == 3);
        CHECK(count(ThingKind::Lantern) >= 2);
        CHECK(count(ThingKind::Coin) >= 15);
        CHECK(count(ThingKind::Snuffer) >= 2);
        CHECK_FALSE(level.platforms.empty());
    }
}

TEST_CASE("in the three levels every standing thing is on a floor, and slopes begin and end at the ground",
          "[games][runner]") {
    for (const LevelText& text : builtInLevels()) {
        const Level level = readLevel(text.text, text.file);
        const TileMap& tiles = level.tiles;
        const auto isFloor = [&](const Vec2& at) {
            const Tile tile = tiles.at(tiles.cellAt(at));
            return !isEmpty(tile) && (tile.kind == TileKind::Solid || tile.kind == TileKind::OneWay);
        };
        std::vector<Vec2> standing{level.start, level.beacon};
        for (const Thing& thing : level.things)
            if (thing.kind == ThingKind::Lantern || thing.kind == ThingKind::Spring ||
                thing.kind == ThingKind::Snuffer || thing.kind == ThingKind::Burr)
                standing.push_back(thing.at);
        for (const Vec2& at : standing) {
            INFO(text.file << ": " << at.transpose());
            CHECK(isFloor(at - Vec2(0, 1)));
        }
        for (int row = 0; row < tiles.rows(); ++row)
            for (int column = 0; column < tiles.columns(); ++column) {
                const TileForm form = tiles.at({column, row}).form;
                const bool up = form == TileForm::SlopeUp || form == TileForm::GentleUpLow;
                const bool down = form == TileForm::SlopeDown || form == TileForm::GentleDownLow;
                if (!up && !down) continue;
                INFO(text.file << ": column " << column << ", row " << row);
                const Vec2 before = tiles.centerOf({column, row}) + Vec2(up ? -1 : 1, 0);
                CHECK_FALSE(isFloor(before));
                CHECK(isFloor(before - Vec2(0, 1)));
            }
    }
}
