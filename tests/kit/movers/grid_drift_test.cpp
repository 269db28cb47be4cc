// SPDX-License-Identifier: MIT
// Is a grid mover, after any number of ticks, where speed times time says?
#include <cmath>
#include <iostream>

#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>
#include <plumb/movers/grid_mover.h>
#include <plumb/stepping/interpolate.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/mazes.h"
#include "kit/movers/stage.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

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
            const double passed = random.uniform(0, 1.0 / 30);
            time += passed;
            cells += count(mover.move(map, 3.7, passed), GridEventKind::Entered);
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
