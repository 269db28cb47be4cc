// SPDX-License-Identifier: MIT
// What the maze game of 1980 counts and where its maze has rules of its own, from "The Pac-Man Dossier"; the tunnel's
// cells and the starting pixels from a clone's source. Columns count from the left, rows from above, as there.
#include <plumb/movers/arcade_maze.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/movers/grid_choice.h>

#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

constexpr int mazeRows = 36;

Cell fromAbove(int column, int row) {
    return {column, mazeRows - 1 - row};
}

/// The tunnel's row alone, open from edge to edge, and around.
TileMap tunnelRow() {
    TileMap map = filled({.columns = 28, .rows = mazeRows, .wrapX = true});
    for (int column = 0; column < 28; ++column) map.set(fromAbove(column, 17), {});
    return map;
}

}  // namespace

TEST_CASE("fruit is worth 100, 300, 500 x2, 700 x2, 1000 x2, 2000 x2, 3000 x2 and 5000 from level 13 on", "[arcade]") {
    const std::vector<int> points{100, 300, 500, 500, 700, 700, 1000, 1000, 2000, 2000, 3000, 3000, 5000, 5000};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ArcadeFruit fruit = arcadeFruit(static_cast<int>(i) + 1);
        CHECK(fruit.points == points[i]);
        // A new picture with each new worth.
        const int before = i == 0 ? -1 : arcadeFruit(static_cast<int>(i)).kind;
        CHECK(fruit.kind == (i > 0 && points[i] == points[i - 1] ? before : before + 1));
    }
    CHECK(arcadeFruit(256).points == 5000);
    CHECK(arcadeFruit(256).kind == 7);
    CHECK_THROWS_AS(arcadeFruit(0), std::invalid_argument);
}

TEST_CASE("all dots of a level make 2600 points, four hunters 3000, and fruit comes at 70 and 170 dots for 9 to 10 s",
          "[arcade]") {
    const ArcadeProfile arcade;
    CHECK(arcade.dots * arcade.dotPoints + arcade.energizers * arcade.energizerPoints == 2600);
    CHECK(arcade.dotPoints == 10);
    CHECK(arcade.hunterPoints == std::array{200, 400, 800, 1600});
    CHECK(arcade.fruitAfter == std::array{70, 170});
    CHECK(arcade.fruitTime == std::array{9.0, 10.0});
}

TEST_CASE("a hunter goes through the tunnel at 40, 45 and 50 %, frame by frame and in real time", "[arcade][movers]") {
    const TileMap map = tunnelRow();
    const ArcadeMaze maze = arcadeMaze();
    const ArcadeProfile arcade;
    for (const auto& [level, percent] : {std::pair(1, 40), {2, 45}, {4, 45}, {5, 50}, {20, 50}, {21, 50}}) {
        const ArcadeSpeeds speeds = arcadeSpeeds(level);
        for (const bool frightened : {false, true}) {
            GridMover hunter({.cell = fromAbove(13, 17), .reverses = false});
            constexpr int laps = 20;
            int slow = 0, fast = 0;
            for (int lap = 0; lap < laps;) {
                const bool inTunnel = isSlow(maze, hunter.cell());
                ++(inTunnel ? slow : fast);
                const int now = hunterPercent(speeds, inTunnel, frightened);
                for (const GridEvent& event : hunter.moveFrame(map, speedPattern(now)))
                    lap += event.kind == GridEventKind::Entered && event.cell == fromAbove(13, 17);
            }
            const int own = frightened && speeds.hunterFright > 0 ? speeds.hunterFright : speeds.hunter;
            INFO("level " << level << (frightened ? ", frightened" : ""));
            // 12 tiles of 8 pixels a lap are the tunnel, which it enters and leaves once a lap: the two ends join. A
            // pattern is less than a pixel off its speed at each, which are two frames at half a pixel a frame. It
            // began 4 pixels from the edge of a tile.
            CHECK(std::fabs(slow - laps * 96 / (1.25 * percent / 100)) <= 2 * 2 * laps);
            CHECK(std::fabs(fast - (laps * 128 - 4) / (1.25 * own / 100)) <= 2 * 2 * laps + 8);
            // The tunnel's speed and no other: those of the other levels are 5 % and more off.
            CHECK(std::fabs(slow - laps * 96 / (1.25 * percent / 100)) < 0.05 * slow);
        }
        // In real time: from edge to edge of the first six tiles, 48 pixels.
        GridMover runner({.cell = fromAbove(0, 17)});
        const double full = arcade.fullSpeed * arcade.tickRate / arcade.pixelsPerTile, dt = 1e-4;
        double time = 0;
        while (isSlow(maze, runner.cell())) {
            runner.move(map, full * hunterPercent(speeds, true, false) / 100, dt);
            time += dt;
        }
        // From the first centre on 5.5 tiles, at 75.75757625 pixels a second for 100 %.
        CHECK(std::fabs(time - 44 / (75.75757625 * percent / 100)) < 2 * dt);
    }
}

TEST_CASE("the tunnel is 6 tiles at each end of row 17 from above, and no other tile of the 1,008", "[arcade]") {
    const ArcadeMaze maze = arcadeMaze();
    int slow = 0;
    for (int row = 0; row < mazeRows; ++row)
        for (int column = 0; column < 28; ++column) slow += isSlow(maze, {column, row});
    CHECK(slow == 12);
    for (const int column : {0, 5, 22, 27}) CHECK(isSlow(maze, fromAbove(column, 17)));
    for (const int column : {6, 21}) CHECK_FALSE(isSlow(maze, fromAbove(column, 17)));
}

TEST_CASE("hunters do not turn up at (12, 14), (15, 14), (12, 26) and (15, 26), but when frightened", "[arcade]") {
    const ArcadeMaze maze = arcadeMaze();
    const TileMap open({.columns = 28, .rows = mazeRows});
    for (const Cell cell : {fromAbove(12, 14), fromAbove(15, 14), fromAbove(12, 26), fromAbove(15, 26)}) {
        const Cell target{cell.column, cell.row + 5};
        GridCrossing crossing{.cell = cell, .heading = Direction::Right};
        CHECK(nextDirection(open, crossing, target) == Direction::Up);
        crossing.upClosed = isUpClosed(maze, cell, false);
        CHECK(nextDirection(open, crossing, target) == Direction::Right);
        CHECK_FALSE(isUpClosed(maze, cell, true));
        CHECK_FALSE(isUpClosed(maze, {cell.column + 1, cell.row}, false));
    }
    CHECK(maze.upClosed.size() == 4);
}

TEST_CASE("hunters start at pixels (112, 116), (112, 140), (96, 140) and (128, 140), half a tile beside a centre",
          "[arcade][movers]") {
    const TileMap open({.columns = 28, .rows = mazeRows});
    const ArcadeMaze maze = arcadeMaze();
    const std::vector<Vec2> pixels{{112, 116}, {112, 140}, {96, 140}, {128, 140}};
    for (std::size_t i = 0; i < 4; ++i) {
        const GridPlace& start = maze.starts[i];
        CHECK(std::fabs(start.offset.x()) == 0.5);
        for (const Direction heading : {Direction::Left, Direction::Right}) {
            GridMover hunter({.cell = start.cell, .offset = start.offset, .heading = heading, .reverses = false});
            const Vec2 place = hunter.position(open) * 8;
            CHECK(Vec2(place.x(), mazeRows * 8 - place.y()) == pixels[i]);
            // To the next centre there are 4 pixels, and 8 to the one after it.
            int centres = 0;
            for (int frame = 1; frame <= 12; ++frame)
                if (count(hunter.moveFrame(open, onePixelAFrame), GridEventKind::ReachedCentre) > 0) {
                    CHECK((frame == 4 || frame == 12));
                    ++centres;
                }
            CHECK(centres == 2);
        }
    }
    // Of any pixel, the place is that pixel, within its cell.
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const int x = random.integer(1, 224), y = random.integer(0, 287);
        const GridPlace place = placeOfPixel(x, y);
        CHECK(open.contains(place.cell));
        CHECK((8 * (open.centerOf(place.cell) + place.offset) - Vec2(x, mazeRows * 8 - y)).isZero(0));
        CHECK(place.offset.minCoeff() > -0.5);
        CHECK(place.offset.maxCoeff() <= 0.5);
    }
}

TEST_CASE("an offset aside of the heading, or beyond half a tile, is refused", "[movers]") {
    CHECK_NOTHROW(GridMover({.offset = {0.5, 0}}));
    CHECK_NOTHROW(GridMover({.offset = {0, -0.49}, .heading = Direction::Down}));
    CHECK_THROWS_WITH(GridMover({.offset = {0, 0.5}}), containsText("GridMoverDef.offset"));
    CHECK_THROWS_AS(GridMover({.offset = {-0.5, 0}}), std::invalid_argument);
    CHECK_THROWS_AS(GridMover({.offset = {0.51, 0}}), std::invalid_argument);
    CHECK_THROWS_AS(GridMover({.offset = {std::nan(""), 0}}), std::invalid_argument);
}

TEST_CASE("the four hunters make for the player, 4 tiles ahead, a mirrored tile, or their own corner", "[arcade]") {
    const ArcadeMaze maze = arcadeMaze();
    const Cell player = fromAbove(10, 20), chaser = fromAbove(12, 14);
    const auto target = [&](int hunter, Direction heading, Cell self = fromAbove(1, 5)) {
        return hunterTarget(hunter, {.hunter = self, .player = player, .heading = heading, .chaser = chaser}, maze);
    };
    CHECK(target(0, Direction::Up) == player);
    CHECK(target(1, Direction::Left) == fromAbove(6, 20));
    CHECK(target(1, Direction::Right) == fromAbove(14, 20));
    CHECK(target(1, Direction::Down) == fromAbove(10, 24));
    CHECK(target(1, Direction::Up) == fromAbove(6, 16));
    // 2 (10 + 2, 20) - (12, 14), and 2 (10 - 2, 20 - 2) - (12, 14).
    CHECK(target(2, Direction::Right) == fromAbove(12, 26));
    CHECK(target(2, Direction::Up) == fromAbove(4, 22));
    CHECK(target(3, Direction::Up, fromAbove(18, 20)) == player);
    CHECK(target(3, Direction::Up, fromAbove(17, 20)) == fromAbove(0, 35));
    CHECK(maze.corners == std::array{fromAbove(25, 0), fromAbove(2, 0), fromAbove(27, 35), fromAbove(0, 35)});
    CHECK(maze.door == fromAbove(13, 14));
    CHECK_THROWS_AS(target(4, Direction::Up), std::invalid_argument);
    CHECK_THROWS_AS(target(-1, Direction::Up), std::invalid_argument);
}
