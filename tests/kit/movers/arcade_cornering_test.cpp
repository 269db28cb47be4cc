// SPDX-License-Identifier: MIT
// The arcade's turns, pixel by pixel, at one pixel a frame.
#include <cstdlib>

#include <plumb/movers/arcade_profile.h>

#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

struct Approach {
    Direction heading;
    int before, after;  ///< pixels of the window
};

/// "Entering from the left: three pre-turn pixels, and four post-turn; from the right four and three; from the top as
/// opposed to the bottom the same." Centre pixel 3 from the left and 4 from the top, as remakes have it.
const std::vector<Approach> approaches{
    {Direction::Right, 3, 4}, {Direction::Left, 4, 3}, {Direction::Up, 3, 4}, {Direction::Down, 4, 3}};

const Cell middle{4, 4};

/// The cell so many cells away in a direction.
Cell away(Cell cell, Direction direction, int cells) {
    for (; cells > 0; --cells) cell = neighbourOf(cell, direction);
    return cell;
}

struct Pixel {
    int along, across;  ///< of the centre of the crossing: in the first heading, in the second
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

Pixel pixelOf(const GridMover& mover, const TileMap& map, Direction first, Direction second) {
    const Vec2 place = (mover.position(map) - map.centerOf(middle)) * 8;
    return {static_cast<int>(place.dot(unitOf(first))), static_cast<int>(place.dot(unitOf(second)))};
}

/// Sets out two cells before the crossing and goes on to the pixel given, in its first heading.
GridMover onItsWay(const TileMap& map, Direction heading, int along) {
    GridMover mover(
        {.cell = away(middle, opposite(heading), 2), .heading = heading, .cornering = ArcadeProfile{}.cornering});
    for (int pixel = -16; pixel < along; ++pixel) mover.moveFrame(map, onePixelAFrame);
    return mover;
}

template <typename Body>
void forEveryTurn(const Body& body) {
    for (const Approach& approach : approaches)
        for (const Direction exit : allDirections)
            if (isHorizontal(exit) != isHorizontal(approach.heading)) body(approach, exit);
}

}  // namespace

TEST_CASE("every early turn gains and every late turn loses a frame a pixel, from 3 or 4 before to 4 or 3 after",
          "[arcade][movers]") {
    const TileMap map = crossOfLanes();
    forEveryTurn([&](const Approach& from, Direction exit) {
        for (int at = -from.before; at <= from.after; ++at) {
            CAPTURE(static_cast<int>(from.heading), static_cast<int>(exit), at);
            GridMover mover = onItsWay(map, from.heading, at);
            REQUIRE(pixelOf(mover, map, from.heading, exit) == Pixel{at, 0});
            mover.want(exit);
            for (int frame = 1; frame <= 16; ++frame) {
                const auto events = mover.moveFrame(map, onePixelAFrame);
                if (frame == 1) REQUIRE(count(events, GridEventKind::Turned) == 1);
                REQUIRE(mover.heading() == exit);
                // A pixel on both axes until it is on the new lane, then straight on.
                const int left = std::max(std::abs(at) - frame, 0);
                REQUIRE(pixelOf(mover, map, from.heading, exit) == Pixel{at < 0 ? -left : left, frame});
            }
            // So 16 pixels out on frame 16 + at after the centre would have been met: at frames later than an ideal
            // turn at the centre, and before + at later than the earliest.
        }
    });
}

TEST_CASE("a turn wanted 12 pixels before the centre begins 3 or 4 before it, one a pixel too late not at all",
          "[arcade][movers]") {
    const TileMap map = crossOfLanes();
    forEveryTurn([&](const Approach& from, Direction exit) {
        CAPTURE(static_cast<int>(from.heading), static_cast<int>(exit));
        GridMover early = onItsWay(map, from.heading, -12);
        early.want(exit);
        for (int at = -12; at < -from.before; ++at) early.moveFrame(map, onePixelAFrame);
        CHECK(early.heading() == from.heading);
        CHECK(pixelOf(early, map, from.heading, exit) == Pixel{-from.before, 0});
        early.moveFrame(map, onePixelAFrame);
        CHECK(early.heading() == exit);
        CHECK(pixelOf(early, map, from.heading, exit) == Pixel{-from.before + 1, 1});

        GridMover late = onItsWay(map, from.heading, from.after + 1);
        late.want(exit);
        for (int frame = 0; frame < 11; ++frame) late.moveFrame(map, onePixelAFrame);
        CHECK(late.heading() == from.heading);
        CHECK(pixelOf(late, map, from.heading, exit) == Pixel{from.after + 12, 0});
        CHECK(late.wanted() == exit);
    });
}

TEST_CASE("hunters, whose windows are 0, turn at the centre only, to the pixel", "[arcade][movers]") {
    const TileMap map = crossOfLanes();
    forEveryTurn([&](const Approach& from, Direction exit) {
        GridMover hunter({.cell = away(middle, opposite(from.heading), 2), .heading = from.heading, .reverses = false});
        hunter.want(exit);
        for (int frame = 1; frame <= 32; ++frame) {
            hunter.moveFrame(map, onePixelAFrame);
            const Pixel there = frame <= 16 ? Pixel{frame - 16, 0} : Pixel{0, frame - 16};
            REQUIRE(pixelOf(hunter, map, from.heading, exit) == there);
        }
    });
}

TEST_CASE("the player turns back within a frame, wherever it is, and a hunter not at all", "[arcade][movers]") {
    const TileMap map = crossOfLanes();
    for (const Approach& from : approaches)
        for (int at = -15; at <= 15; ++at) {
            const Direction back = opposite(from.heading), side = clockwise(from.heading);
            GridMover player = onItsWay(map, from.heading, at);
            player.want(back);
            player.moveFrame(map, onePixelAFrame);
            CHECK(player.heading() == back);
            CHECK(pixelOf(player, map, from.heading, side) == Pixel{at - 1, 0});

            GridMover hunter({.cell = away(middle, back, 2), .heading = from.heading, .reverses = false});
            for (int pixel = -16; pixel < at; ++pixel) hunter.moveFrame(map, onePixelAFrame);
            hunter.want(back);
            hunter.moveFrame(map, onePixelAFrame);
            CHECK(pixelOf(hunter, map, from.heading, side) == Pixel{at + 1, 0});
        }
}

TEST_CASE("a hunter told to reverse does so on the first pixel of the next tile, once", "[arcade][movers]") {
    const TileMap map = crossOfLanes();
    for (const Approach& from : approaches) {
        const Direction back = opposite(from.heading), side = clockwise(from.heading);
        GridMover hunter({.cell = away(middle, back, 2), .heading = from.heading, .reverses = false});
        for (int frame = 0; frame < 10; ++frame) hunter.moveFrame(map, onePixelAFrame);
        hunter.reverseOnEntry();  // 6 pixels before the centre: in the tile before the crossing
        const int first = -from.before;
        for (int at = -6; at < first; ++at) {
            hunter.moveFrame(map, onePixelAFrame);
            CHECK(hunter.heading() == from.heading);
        }
        CHECK(hunter.cell() == middle);
        for (int frame = 1; frame <= 20; ++frame) {
            const auto events = hunter.moveFrame(map, onePixelAFrame);
            CHECK(count(events, GridEventKind::Reversed) == (frame == 1 ? 1 : 0));
            CHECK(hunter.heading() == back);
            CHECK(pixelOf(hunter, map, from.heading, side) == Pixel{first - frame, 0});
        }
    }
}
