// SPDX-License-Identifier: MIT
// The arcade's speeds, frame by frame, from what its programs show and not from this kit's tables.
#include <bit>
#include <cmath>
#include <iostream>
#include <vector>

#include <plumb/movers/arcade_profile.h>
#include <plumb/movers/grid_pattern.h>

#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// "The Pac-Man Dossier", table A.1: levels from and to; then player, its dots, in fright, its dots in fright, hunter,
/// in fright, in the tunnel, first haste, second; -1 where it has a dash.
struct Row {
    int from, to;
    int player, dots, fright, frightDots, hunter, hunterFright, tunnel, haste1, haste2;
};

const std::vector<Row> table{{1, 1, 80, 71, 90, 79, 75, 50, 40, 80, 85},
                             {2, 4, 90, 79, 95, 83, 85, 55, 45, 90, 95},
                             {5, 20, 100, 87, 100, 87, 95, 60, 50, 100, 105},
                             {21, 256, 90, 79, -1, -1, 95, -1, 50, 100, 105}};

constexpr int laneLength = 256;

/// How far along a lane to the right of 8-pixel tiles.
int pixelsAlong(const GridMover& mover) {
    return 8 * mover.cell().column + static_cast<int>(mover.offset().x() * 8);
}

GridMover onLane() {
    return GridMover({.cell = {0, 1}});
}

/// The dots are 8 pixels apart; the stall begins with the frame after the one that entered the tile.
double percentThroughDots(int percent, int tiles) {
    const TileMap map = lane(true, laneLength, true);
    GridMover mover = onLane();
    int frames = 0;
    for (int eaten = 0; eaten < tiles; ++frames)
        for (const GridEvent& event : mover.moveFrame(map, speedPattern(percent)))
            if (event.kind == GridEventKind::Entered) {
                mover.pauseFrames(1);
                ++eaten;
            }
    // 3 pixels less: it began at a centre and ended on the first pixel of a tile. The last stall is still to come.
    return 100 * (8.0 * tiles - 3) / (1.25 * (frames + 1));
}

/// To a tenth, and from there to a whole: so 86.486 is 87.
int roundedTwice(double percent) {
    return static_cast<int>(std::floor(std::floor(percent * 10 + 0.5) / 10 + 0.5));
}

}  // namespace

TEST_CASE("speeds of all level bands are p / 5 pixels in 16 frames, 2 p / 5 in 32, from whichever frame",
          "[arcade][movers]") {
    const TileMap map = lane(true, laneLength, false);
    for (const Row& row : table)
        for (const int percent :
             {row.player, row.fright, row.hunter, row.hunterFright, row.tunnel, row.haste1, row.haste2}) {
            if (percent < 0) continue;
            CAPTURE(row.from, percent);
            CHECK(std::popcount(speedPattern(percent).bits) == percent / 5);
            for (int phase = 0; phase < 16; ++phase) {
                GridMover mover = onLane();
                for (int frame = 0; frame < phase; ++frame) mover.moveFrame(map, speedPattern(percent));
                const int start = pixelsAlong(mover);
                for (int frame = 0; frame < 32; ++frame) mover.moveFrame(map, speedPattern(percent));
                // 1.25 pixels a frame are 100 %: 40 in 32 frames.
                REQUIRE(100 * (pixelsAlong(mover) - start) == 40 * percent);
            }
        }
}

TEST_CASE("at 5 % to 160 %, after each of 64 frames, a mover is less than a pixel behind its speed, never ahead",
          "[arcade][movers]") {
    const TileMap map = lane(true, laneLength, false);
    for (int percent = 5; percent <= 160; percent += 5) {
        GridMover mover = onLane();
        for (int frame = 1; frame <= 64; ++frame) {
            const int before = pixelsAlong(mover);
            mover.moveFrame(map, speedPattern(percent));
            CAPTURE(percent, frame);
            const double behind = 0.0125 * percent * frame - pixelsAlong(mover);
            REQUIRE(behind > -1e-9);  // whole numbers and a product of two: it is 0 to rounding, or 1/16 or more
            REQUIRE(behind < 1);
            const int step = pixelsAlong(mover) - before;
            REQUIRE((step >= 0 && step <= 2));
        }
    }
}

TEST_CASE("a frame's stall a dot makes 71, 79, 87 % of 80, 90, 100 %, as it says in the columns of dots",
          "[arcade][movers]") {
    for (const Row& row : table) {
        CAPTURE(row.from);
        // 8 pixels at 1.25 p / 100 a frame, and the stall: 100 p / (100 + p / 6.4) percent.
        for (const auto& [speed, column] : {std::pair{row.player, row.dots}, std::pair{row.fright, row.frightDots}}) {
            if (speed < 0) continue;
            const double closed = 8 / (8 / (1.25 * speed / 100) + 1) / 1.25 * 100;
            const double outcome = percentThroughDots(speed, 20000);
            // Off by the frames of one tile at the end of 20,000.
            CHECK(std::fabs(outcome - closed) < closed / 20000);
            CHECK(roundedTwice(outcome) == column);
            std::cout << speed << " % through dots: " << outcome << " %; closed form " << closed << ", table " << column
                      << '\n';
        }
    }
}

TEST_CASE("an energizer's three frames, a dot's one: the player stands so many, and its pattern with it",
          "[arcade][movers]") {
    const TileMap map = lane(true, laneLength, false);
    const ArcadeProfile arcade;
    for (const int stall : {arcade.dotStall, arcade.energizerStall}) {
        GridMover stalled = onLane(), free = onLane();
        for (int frame = 0; frame < 5; ++frame) {
            stalled.moveFrame(map, speedPattern(100));
            free.moveFrame(map, speedPattern(100));
        }
        stalled.pauseFrames(stall);
        for (int frame = 0; frame < stall; ++frame) {
            CHECK(stalled.moveFrame(map, speedPattern(100)).empty());
            CHECK(pixelsAlong(stalled) == pixelsAlong(free));
        }
        for (int frame = 0; frame < 40; ++frame) {
            stalled.moveFrame(map, speedPattern(100));
            free.moveFrame(map, speedPattern(100));
            CHECK(pixelsAlong(stalled) == pixelsAlong(free));
        }
    }
    CHECK(arcade.dotStall == 1);
    CHECK(arcade.energizerStall == 3);
}

TEST_CASE("the profile's speeds are the table's, level by level to 256", "[arcade]") {
    const auto orNone = [](int percent) { return percent < 0 ? 0 : percent; };
    for (const Row& row : table)
        for (int level = row.from; level <= row.to; ++level) {
            CAPTURE(level);
            const ArcadeSpeeds speeds = arcadeSpeeds(level);
            CHECK(speeds.player == row.player);
            CHECK(speeds.playerFright == orNone(row.fright));
            CHECK(speeds.hunter == row.hunter);
            CHECK(speeds.hunterFright == orNone(row.hunterFright));
            CHECK(speeds.hunterTunnel == row.tunnel);
            CHECK(speeds.haste1 == row.haste1);
            CHECK(speeds.haste2 == row.haste2);
        }
}

TEST_CASE("100 % is 75.75757625 pixels or 9.46969703 tiles a second", "[arcade]") {
    const ArcadeProfile arcade;
    // The digits given are eight behind the point.
    CHECK(std::fabs(arcade.fullSpeed * arcade.tickRate - 75.75757625) < 1e-8);
    CHECK(std::fabs(arcade.fullSpeed * arcade.tickRate / arcade.pixelsPerTile - 9.46969703) < 1e-8);
}

TEST_CASE("a pattern of 162 %, -5 % or 165 % is refused", "[arcade][movers]") {
    for (const int percent : {162, -5, 165, 1}) CHECK_THROWS_AS(speedPattern(percent), std::invalid_argument);
    CHECK_THROWS_WITH(speedPattern(81), containsText("speedPattern: percent: 81 is not a multiple of 5"));
}
