// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_choice.h>

#include <algorithm>
#include <iostream>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// In the arcade's order of preference.
constexpr Direction byPreference[]{Direction::Up, Direction::Left, Direction::Down, Direction::Right};

bool reverses(Direction exit, Direction heading) {
    return unitOf(exit) == Vec2(-unitOf(heading));
}

}  // namespace

TEST_CASE("with all exits open, equally good ones go up before left before down before right", "[arcade][movers]") {
    const TileMap map({.columns = 9, .rows = 9});
    const auto choice = [&](Direction heading, Cell target) {
        return nextDirection(map, {.cell = {4, 4}, .heading = heading}, target);
    };
    CHECK(choice(Direction::Right, {4, 4}) == Direction::Up);   // all four are one away
    CHECK(choice(Direction::Down, {4, 4}) == Direction::Left);  // up is its reverse
    CHECK(choice(Direction::Up, {0, 0}) == Direction::Left);    // left and down are equal
    CHECK(choice(Direction::Right, {8, 8}) == Direction::Up);   // up and right are equal
    CHECK(choice(Direction::Left, {8, 0}) == Direction::Down);  // right is its reverse
    CHECK(choice(Direction::Right, {8, 4}) == Direction::Right);
    CHECK(nextDirection(map, {.cell = {4, 4}, .heading = Direction::Right, .upClosed = true}, {4, 8}) ==
          Direction::Right);  // down is farther
}

TEST_CASE("a hunter's choice is the best of all exits in 100,000 crossings, by brute force", "[arcade][movers]") {
    Random random(1);
    int deadEnds = 0;
    const int runs = cases(100000);
    for (int run = 0; run < runs; ++run) {
        const TileMap map = randomMaze(random);
        const OpenCells open(map);
        const GridCrossing crossing{.cell = {random.integer(0, map.columns() - 1), random.integer(0, map.rows() - 1)},
                                    .heading = static_cast<Direction>(random.integer(0, 3)),
                                    .upClosed = random.integer(0, 3) == 0};
        const Cell target{random.integer(-5, 25), random.integer(-5, 25)};
        const auto legal = [&](Direction exit) {
            return open.ahead(crossing.cell, exit) && !reverses(exit, crossing.heading) &&
                   !(crossing.upClosed && exit == Direction::Up);
        };
        const auto distance = [&](Direction exit) {
            const Cell next = open.next(crossing.cell, exit);
            const int x = next.column - target.column, y = next.row - target.row;
            return x * x + y * y;
        };
        const auto chosen = nextDirection(map, crossing, target);
        const auto turned = firstOpenClockwise(map, crossing, static_cast<Direction>(run % 4));
        const int exits = static_cast<int>(std::count_if(std::begin(byPreference), std::end(byPreference), legal));
        CAPTURE(run);
        REQUIRE(chosen.has_value() == (exits > 0));
        REQUIRE(turned.has_value() == (exits > 0));
        deadEnds += exits == 0 ? 1 : 0;
        if (!chosen) continue;
        REQUIRE(legal(*chosen));
        REQUIRE(legal(*turned));
        bool earlier = true;
        for (const Direction other : byPreference) {
            earlier = earlier && other != *chosen;
            if (!legal(other) || other == *chosen) continue;
            REQUIRE((earlier ? distance(other) > distance(*chosen) : distance(other) >= distance(*chosen)));
        }
    }
    CHECK(deadEnds > runs / 1000);
    std::cout << "crossings chosen at: " << runs << ", " << deadEnds << " of them dead ends\n";
}

TEST_CASE("a hunter that decides a tile ahead leaves each of 2,000 tiles by the exit it chose, and never stops",
          "[arcade][movers]") {
    TileMap map = filled({.columns = 14, .rows = 11, .wrapX = true});
    for (int row = 1; row < 10; ++row)
        for (int column = 0; column < 14; ++column)
            if (row % 2 == 1 || column % 2 == 1) map.set({column, row}, {});
    Random random(4);
    GridMover hunter({.cell = {7, 5}, .heading = Direction::Right, .reverses = false});
    Direction exit = Direction::Right, exitOfNext = Direction::Right;  // along row 5: (8, 5) has no other
    Cell target{1, 9};
    int tiles = 0, caught = 0;
    for (int frame = 0; frame < 2000 * 8; ++frame)
        for (const GridEvent& event : hunter.moveFrame(map, speedPattern(80))) {
            REQUIRE(event.kind != GridEventKind::Stopped);
            REQUIRE(event.kind != GridEventKind::Reversed);
            if (event.kind != GridEventKind::Entered) continue;
            ++tiles;
            REQUIRE(event.direction == exit);
            exit = exitOfNext;
            hunter.want(exit);
            const Cell next = map.wrapped(neighbourOf(event.cell, exit));
            exitOfNext = nextDirection(map, {.cell = next, .heading = exit}, target).value();
            caught += event.cell == target ? 1 : 0;
            // One that circles its target, as they do, is given another.
            if (event.cell == target || tiles % 100 == 0)
                target = {2 * random.integer(0, 6) + 1, 2 * random.integer(0, 4) + 1};
        }
    CHECK(tiles == 2000);  // 80 % is a pixel a frame: no turn, and no decision, costs it one
    CHECK(caught > 20);
    std::cout << "hunter: " << tiles << " tiles, " << caught << " times at its target\n";
}

TEST_CASE("who wants up, and finds walls above and to the right, goes down", "[arcade][movers]") {
    TileMap map({.columns = 3, .rows = 3});
    map.set({1, 2}, wallTile);
    map.set({2, 1}, wallTile);
    const GridCrossing crossing{.cell = {1, 1}, .heading = Direction::Down};
    CHECK(firstOpenClockwise(map, crossing, Direction::Up) == Direction::Down);
    CHECK(firstOpenClockwise(map, crossing, Direction::Left) == Direction::Left);
}

TEST_CASE("directions by their names: opposites, clockwise turns, units, angles, neighbours", "[movers]") {
    for (const Direction direction : allDirections) {
        CHECK(unitOf(opposite(direction)) == Vec2(-unitOf(direction)));
        CHECK(unitOf(clockwise(direction)) == Vec2(-perp(unitOf(direction))));
        const Rot turn = Rot::fromAngle(angleOf(direction));
        CHECK((turn * Vec2(1, 0) - unitOf(direction)).norm() < 1e-15);
        CHECK(neighbourOf({3, 7}, direction) == OpenCells(TileMap{}).next({3, 7}, direction));
    }
    CHECK(unitOf(Direction::Up) == Vec2(0, 1));
    CHECK(unitOf(Direction::Left) == Vec2(-1, 0));
}
