// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_mover.h>

#include <cmath>
#include <iostream>
#include <limits>

#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>
#include <plumb/stepping/interpolate.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;
using Kind = GridEventKind;

std::vector<GridEvent> listOf(std::span<const GridEvent> events) {
    return {events.begin(), events.end()};
}

}  // namespace

TEST_CASE("3.25 tiles at once from (1, 1) to the right: events in their order, a quarter beyond the centre of (4, 1)",
          "[movers]") {
    GridMover mover({.cell = {1, 1}});
    const auto events = listOf(mover.move(lane(true, 8, false), 13, 0.25));
    const std::vector<GridEvent> expected{
        {Kind::Entered, {2, 1}, Direction::Right}, {Kind::ReachedCentre, {2, 1}, Direction::Right},
        {Kind::Entered, {3, 1}, Direction::Right}, {Kind::ReachedCentre, {3, 1}, Direction::Right},
        {Kind::Entered, {4, 1}, Direction::Right}, {Kind::ReachedCentre, {4, 1}, Direction::Right}};
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
                if (event.kind == Kind::Stopped) stops.push_back(event);
        CHECK(stops == std::vector<GridEvent>{{Kind::Stopped, neighbourOf({4, 4}, heading), heading}});
        CHECK(mover.stopped());
        CHECK(mover.offset() == Vec2(0, 0));

        GridMover back = mover;
        back.want(opposite(heading));
        CHECK(listOf(back.move(map, 1, 0.25)).front().kind == Kind::Reversed);
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
            wraps += count(events, Kind::Wrapped);
            if (count(events, Kind::Wrapped) == 1) {
                REQUIRE(events.size() == 2);
                REQUIRE(events[0].kind == Kind::Wrapped);
                REQUIRE(events[1].kind == Kind::Entered);
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

TEST_CASE("a door of tag 1 lets in who opens 1; a floor of tag 2 keeps out whom 2 closes; a rule says it by heading",
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

TEST_CASE("a wall put up in front of one that is past the centre sends it back there; nothing stays in a wall",
          "[movers]") {
    TileMap map = lane(true, 8, false);
    GridMover mover({.cell = {2, 1}});
    mover.move(map, 0.25, 1);
    map.set({3, 1}, wallTile);
    const auto events = listOf(mover.move(map, 0.125, 1));
    CHECK(events == std::vector<GridEvent>{{Kind::Reversed, {2, 1}, Direction::Left}});
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
    mover.stand(0.25);
    mover.stand(0.1);
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
}

TEST_CASE("a million ticks of random length at 3.7 tiles/s: as far as speed times time, 62,000 tiles, to 1e-10 tiles",
          "[movers]") {
    const TileMap map = lane(false, 7, true);
    for (const Direction heading : {Direction::Up, Direction::Down}) {
        GridMover mover({.cell = {1, 3}, .heading = heading});
        Random random(11);
        long double time = 0;
        long cells = 0;
        const int ticks = cases(1000000);
        for (int tick = 0; tick < ticks; ++tick) {
            const double dt = random.uniform(0, 1.0 / 30);
            time += dt;
            cells += count(mover.move(map, 3.7, dt), Kind::Entered);
        }
        const double off = mover.offset().dot(unitOf(heading)) - static_cast<double>(3.7L * time - cells);
        // Per tick at most 4 sums of numbers below 4 pixels, each off by 2^-52 pixels, an eighth of that in tiles; they
        // do not lean to one side: so by far less than their sum.
        CHECK(std::fabs(off) < ticks * 4 * 0x1p-55);
        std::cout << ticks << " ticks, " << cells << " cells: off by " << off << " tiles\n";
    }
}

TEST_CASE("ticks of 1/20, 1/60, 1/144 s or one of 1 h are one way: the same cell and place, to rounding", "[movers]") {
    const TileMap map = lane(true, 11, true);
    GridMover whole({.cell = {2, 1}});
    whole.move(map, 2.3, 3600);
    for (const int rate : {20, 60, 144}) {
        GridMover mover({.cell = {2, 1}});
        for (int tick = 0; tick < 3600 * rate; ++tick) mover.move(map, 2.3, 1.0 / rate);
        // 2.3 / rate is rounded alike in each tick: 2^-54 of a way of 8,280 tiles. And sums as above.
        const double bound = 8280 * 0x1p-52 + 3600 * rate * 4 * 0x1p-55;
        CHECK((mover.position(map) - whole.position(map)).norm() < bound);
    }
    // 8,280 tiles are 752 rounds of 11 and 8 more; from 2 that is 10.
    CHECK((whole.position(map) - map.centerOf({10, 1})).norm() < 8280 * 8 * 0x1p-52);
}

TEST_CASE("a kinematic body told each tick stands where the mover is", "[movers]") {
    const TileMap map = crossOfLanes();
    GridMover mover({.cell = {1, 4}, .cornering = {.right = {0.25, 0.25}}});
    mover.want(Direction::Up);
    const double dt = 1.0 / 60;
    World world;
    const BodyId body =
        world.add({.type = BodyType::Kinematic, .position = mover.position(map), .shapes = {circle(0.4)}});
    for (int tick = 0; tick < 100; ++tick) {
        mover.move(map, 4, dt);
        const double angle = world.body(body).angle();
        world.body(body).moveTo(mover.position(map), angle + shortestTurn(angle, angleOf(mover.heading())), dt);
        world.step(dt);
        // A step's way, rounded at places below 16 m, and taken in full.
        REQUIRE((world.body(body).position() - mover.position(map)).norm() < 8 * 0x1p-49);
    }
    CHECK(mover.heading() == Direction::Up);
}

TEST_CASE("unsound numbers are refused by name, and nothing has moved", "[movers]") {
    const TileMap map = lane(true, 8, false);
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
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
        CHECK_THROWS_AS(mover.stand(bad), std::invalid_argument);
    }
    CHECK_THROWS_AS(mover.move(map, 1e200, 1e200), std::invalid_argument);
    CHECK_THROWS_AS(mover.move(map, 1 << 20, 1.001), std::invalid_argument);
    CHECK_THROWS_AS(mover.standFrames(-1), std::invalid_argument);
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
