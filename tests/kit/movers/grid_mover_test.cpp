// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_mover.h>

#include <cmath>

#include "catch.h"
#include "kit/movers/mazes.h"
#include "numbers.h"

namespace {

using namespace plumb;
using namespace plumb::test;

std::vector<GridEvent> listOf(std::span<const GridEvent> events) {
    return {events.begin(), events.end()};
}

}  // namespace

TEST_CASE("3.25 tiles at once from (1, 1) to the right: events in their order, a quarter beyond the centre of (4, 1)",
          "[movers]") {
    GridMover mover({.cell = {1, 1}});
    const auto events = listOf(mover.move(lane(true, 8, false), 13, 0.25));
    const std::vector<GridEvent> expected{
        {GridEventKind::Entered, {2, 1}, Direction::Right}, {GridEventKind::ReachedCentre, {2, 1}, Direction::Right},
        {GridEventKind::Entered, {3, 1}, Direction::Right}, {GridEventKind::ReachedCentre, {3, 1}, Direction::Right},
        {GridEventKind::Entered, {4, 1}, Direction::Right}, {GridEventKind::ReachedCentre, {4, 1}, Direction::Right}};
    CHECK(events == expected);
    CHECK(mover.cell() == Cell{4, 1});
    CHECK(mover.offset() == Vec2(0.25, 0));
}

TEST_CASE(
    "a wall stops a mover exactly at the centre before it, and it goes on when the wall is taken away or it turns",
    "[movers]") {
    for (const Direction heading : allDirections) {
        TileMap map = crossOfLanes();
        const Cell blocked = neighbourOf(neighbourOf({4, 4}, heading), heading);
        map.set(blocked, wallTile);
        GridMover mover({.cell = {4, 4}, .heading = heading});
        std::vector<GridEvent> stops;
        for (int tick = 0; tick < 50; ++tick)
            for (const GridEvent& event : mover.move(map, 0.7, 0.1))
                if (event.kind == GridEventKind::Stopped) stops.push_back(event);
        CHECK(stops == std::vector<GridEvent>{{GridEventKind::Stopped, neighbourOf({4, 4}, heading), heading}});
        CHECK(mover.stopped());
        CHECK(mover.offset() == Vec2(0, 0));

        GridMover back = mover;
        back.want(opposite(heading));
        CHECK(listOf(back.move(map, 1, 0.25)).front().kind == GridEventKind::Reversed);
        CHECK_FALSE(back.stopped());
        CHECK((back.offset() + 0.25 * unitOf(heading)).norm() == 0);

        map.set(blocked, {});
        mover.move(map, 1, 0.25);
        CHECK_FALSE(mover.stopped());
        CHECK((mover.offset() - 0.25 * unitOf(heading)).norm() == 0);
    }
}

TEST_CASE("a lap of a tunnel of 28 tiles takes 224 frames at a pixel a frame: a thousand laps later at its very start",
          "[movers][arcade]") {
    for (const Direction heading : allDirections) {
        const TileMap map = lane(isHorizontal(heading), 28, true);
        const Cell start = isHorizontal(heading) ? Cell{5, 1} : Cell{1, 5};
        GridMover mover({.cell = start, .heading = heading});
        int wraps = 0;
        for (int frame = 1; frame <= 224 * 1000; ++frame) {
            const auto events = mover.moveFrame(map, onePixelAFrame);
            wraps += count(events, GridEventKind::Wrapped);
            if (count(events, GridEventKind::Wrapped) == 1) {
                REQUIRE(events.size() == 2);
                REQUIRE(events[0].kind == GridEventKind::Wrapped);
                REQUIRE(events[1].kind == GridEventKind::Entered);
                REQUIRE(events[1].cell == map.wrapped(events[1].cell));
            }
        }
        CHECK(wraps == 1000);
        CHECK(mover.cell() == start);
        CHECK(mover.offset() == Vec2(0, 0));
    }
}

TEST_CASE("before and behind the edge of a map that wraps a mover keeps its way: 0.5 tiles a tick, none lost",
          "[movers]") {
    const TileMap map = lane(true, 4, true);
    GridMover mover({.cell = {3, 1}, .heading = Direction::Right});
    mover.move(map, 0.25, 1);
    CHECK(mover.position(map) == Vec2(3.75, 1.5));
    mover.move(map, 0.5, 1);
    CHECK(mover.position(map) == Vec2(0.25, 1.5));
}

TEST_CASE("a door of tag 1 lets in who opens 1, a floor of tag 2 keeps out whom 2 closes, a rule says it by heading",
          "[movers]") {
    TileMap map = lane(true, 8, false);
    map.set({3, 1}, {.form = TileForm::Full, .tag = 1});
    map.set({5, 1}, {.form = TileForm::Full, .kind = TileKind::Sensor, .tag = 2});
    const auto reach = [&](const GridPass& pass) {
        GridMover mover({.cell = {0, 1}, .pass = pass});
        mover.move(map, 20, 1);
        return mover.cell().column;
    };
    CHECK(reach({}) == 2);
    CHECK(reach({.opens = 1}) == 7);
    CHECK(reach({.opens = 3}) == 7);
    CHECK(reach({.opens = 2}) == 2);
    CHECK(reach({.opens = 1, .closes = 2}) == 4);
    CHECK(reach({.rule = [](const Tile&, Direction) { return true; }}) == 7);
    CHECK(reach({.rule = [](const Tile&, Direction heading) { return heading != Direction::Right; }}) == 0);
}

TEST_CASE("a wall put up in front of one that is past the centre sends it back there, nothing stays in a wall",
          "[movers]") {
    TileMap map = lane(true, 8, false);
    GridMover mover({.cell = {2, 1}});
    mover.move(map, 0.25, 1);
    map.set({3, 1}, wallTile);
    const auto events = listOf(mover.move(map, 0.125, 1));
    CHECK(events == std::vector<GridEvent>{{GridEventKind::Reversed, {2, 1}, Direction::Left}});
    CHECK(mover.offset() == Vec2(0.125, 0));
    map.set({1, 1}, wallTile);
    mover.move(map, 1, 1);
    CHECK(mover.offset() == Vec2(0, 0));
    CHECK(mover.stopped());
}

TEST_CASE("who may not reverse does in a dead end, when it wants to, and only there", "[movers]") {
    const TileMap map = lane(true, 8, false);
    GridMover mover({.cell = {6, 1}, .reverses = false});
    mover.want(Direction::Left);
    mover.move(map, 0.75, 1);
    CHECK(mover.heading() == Direction::Right);
    mover.move(map, 0.75, 1);
    CHECK(mover.heading() == Direction::Left);
    CHECK(mover.position(map) == Vec2(7, 1.5));
}

TEST_CASE("halted, it stops at the next centre, 3/4 of a tile on, until something is wanted", "[movers]") {
    const TileMap map = lane(true, 8, false);
    GridMover mover({.cell = {1, 1}});
    mover.move(map, 0.25, 1);
    mover.halt();
    mover.move(map, 3, 1);
    CHECK(mover.cell() == Cell{2, 1});
    CHECK(mover.offset() == Vec2(0, 0));
    CHECK(mover.stopped());
    mover.want(Direction::Right);
    mover.move(map, 0.25, 1);
    CHECK(mover.offset() == Vec2(0.25, 0));

    GridMover waiting({.cell = {1, 1}, .halted = true});
    waiting.move(map, 3, 1);
    CHECK(waiting.offset() == Vec2(0, 0));
}

TEST_CASE("standing 0.35 s in ticks of 0.1 s costs 0.35 s of way, not four ticks", "[movers]") {
    const TileMap map = lane(true, 8, false);
    GridMover mover({.cell = {0, 1}});
    mover.pause(0.25);
    mover.pause(0.1);
    for (int tick = 0; tick < 10; ++tick) mover.move(map, 5, 0.1);
    const double way = mover.cell().column + mover.offset().x();
    CHECK(std::fabs(way - 5 * 0.65) < 1e-14);  // 10 sums of numbers below 4: 10 x 2^-51
}

TEST_CASE("cutting a corner at any speed, both axes go alike: 0.3 before the centre at 0.2, 0.1, then 0 off the lane",
          "[movers]") {
    const TileMap map = crossOfLanes();
    GridMover mover({.cell = {3, 4}, .cornering = {.right = {0.5, 0.5}}});
    mover.move(map, 0.7, 1);
    mover.want(Direction::Up);
    const double sides[]{-0.2, -0.1, 0, 0};
    for (int tick = 0; tick < 4; ++tick) {
        mover.move(map, 0.1, 1);
        CHECK(std::fabs(mover.offset().x() - sides[tick]) < 1e-14);
        CHECK(std::fabs(mover.offset().y() - 0.1 * (tick + 1)) < 1e-14);
    }
    CHECK(mover.offset().x() == 0);
    CHECK(mover.wanted() == std::nullopt);
}

TEST_CASE("within one tick a window 0.3 tiles before the centre is met where it opens: 0.7 straight, 0.1 aslant",
          "[movers]") {
    const TileMap map = crossOfLanes();
    GridMover mover({.cell = {3, 4}, .cornering = {.right = {0.3, 0}}});
    mover.want(Direction::Down);
    mover.move(map, 0.8, 1);
    CHECK((mover.offset() - Vec2(-0.2, -0.1)).norm() < 1e-15);
}

TEST_CASE("told to reverse on the very edge of a tile, it goes through that tile first", "[movers]") {
    const TileMap map = lane(true, 8, false);
    for (const Direction heading : {Direction::Left, Direction::Right}) {
        GridMover mover({.cell = {4, 1}, .heading = heading, .reverses = false});
        mover.move(map, heading == Direction::Left ? 0.5 : 0.5 + 0x1p-10, 1);  // the right edge is a tile's own
        const Cell entered = neighbourOf({4, 1}, heading);
        CHECK(mover.cell() == entered);
        mover.reverseOnEntry();
        mover.move(map, 0.5, 1);
        CHECK(mover.heading() == heading);
        mover.move(map, 1, 1);
        CHECK(mover.heading() == opposite(heading));
        CHECK(mover.cell() == entered);
    }
}

TEST_CASE("unsound numbers are refused by name, and nothing has moved", "[movers]") {
    const TileMap map = lane(true, 8, false);
    const double nan = std::nan("");
    CHECK_THROWS_WITH(GridMover({.cornering = {.left = {0.6, 0}}}),
                      "Cornering.left.before: 0.6 is not within 0 to 0.5");
    CHECK_THROWS_AS(GridMover({.cornering = {.up = {0, -0.1}}}), std::invalid_argument);
    CHECK_THROWS_AS(GridMover({.cornering = {.down = {nan, 0}}}), std::invalid_argument);
    CHECK_THROWS_WITH(GridMover({.pixelsPerTile = 0}), "GridMoverDef.pixelsPerTile: 0 is not within 1 to 2^20");
    CHECK_THROWS_WITH(GridMover({.heading = static_cast<Direction>(4)}),
                      "GridMoverDef.heading: 4 is none of the four directions");
    GridMover mover({.cell = {1, 1}});
    CHECK_THROWS_AS(mover.want(static_cast<Direction>(200)), std::invalid_argument);
    CHECK_THROWS_WITH(mover.move(map, -1, 1), "GridMover.move: speed: -1 is negative");
    for (const double bad : {nan, infinity, -1e-300}) {
        CHECK_THROWS_AS(mover.move(map, bad, 1), std::invalid_argument);
        CHECK_THROWS_AS(mover.move(map, 1, bad), std::invalid_argument);
        CHECK_THROWS_AS(mover.pause(bad), std::invalid_argument);
    }
    CHECK_THROWS_AS(mover.move(map, 1e200, 1e200), std::invalid_argument);
    CHECK_THROWS_AS(mover.move(map, 1 << 20, 1.001), std::invalid_argument);
    CHECK_THROWS_AS(mover.pauseFrames(-1), std::invalid_argument);
    CHECK_THROWS_AS(mover.setCornering({.up = {1, 0}}), std::invalid_argument);
    CHECK(mover.position(map) == map.centerOf({1, 1}));
    CHECK(mover.wanted() == std::nullopt);
    GridMover outside({.cell = {8, 1}});
    CHECK_THROWS_WITH(outside.move(map, 1, 1), "GridMover.cell: (8, 1) is not one of 8 columns and 3 rows");
    CHECK(mover.move(map, 0, 1).empty());
    CHECK(mover.move(map, 1, 0).empty());
    CHECK(mover.position(map) == map.centerOf({1, 1}));
}

TEST_CASE("a cell that lies rounds away on a map that wraps is the one that it stands for", "[movers]") {
    const TileMap map = lane(true, 8, true);
    GridMover mover({.cell = {-7, 1}});
    mover.move(map, 0.25, 1);
    CHECK(mover.cell() == Cell{1, 1});
}
