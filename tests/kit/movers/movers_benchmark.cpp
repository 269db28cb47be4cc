// SPDX-License-Identifier: MIT
// What do a thousand movers cost? ./tests/run "[!benchmark]"; a mover's time is a thousandth.
#include <vector>

#include <plumb/math/random.h>
#include <plumb/movers/arcade_profile.h>
#include <plumb/movers/path_mover.h>

#include "catch.h"
#include "kit/movers/mazes.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// Pillars in every other cell of both axes, and 100 x 100 cells that wrap.
TileMap pillars() {
    TileMap map({.columns = 100, .rows = 100, .wrapX = true, .wrapY = true});
    for (int row = 1; row < 100; row += 2)
        for (int column = 1; column < 100; column += 2) map.set({column, row}, wallTile);
    return map;
}

std::vector<GridMover> thousand() {
    Random random(1);
    std::vector<GridMover> movers;
    for (int i = 0; i < 1000; ++i)
        movers.emplace_back(GridMoverDef{.cell = {2 * random.integer(0, 49), 2 * random.integer(0, 49)},
                                         .heading = static_cast<Direction>(random.integer(0, 3)),
                                         .cornering = ArcadeProfile{}.cornering});
    return movers;
}

}  // namespace

TEST_CASE("a tick of a thousand movers", "[.][!benchmark][movers]") {
    const TileMap map = pillars();
    std::vector<GridMover> movers = thousand();
    Random random(2);
    const SpeedPattern pattern = speedPattern(80);
    BENCHMARK("1,000 grid movers, 9.5 tiles/s, 1/60 s, each with a turn wanted") {
        std::size_t events = 0;
        for (GridMover& mover : movers) {
            mover.want(static_cast<Direction>(random.bits() & 3));
            events += mover.move(map, 9.5, 1.0 / 60).size();
        }
        return events;
    };
    BENCHMARK("1,000 grid movers, a frame at 80 %") {
        std::size_t events = 0;
        for (GridMover& mover : movers) {
            mover.want(static_cast<Direction>(random.bits() & 3));
            events += mover.moveFrame(map, pattern).size();
        }
        return events;
    };
    const PathMover lift({.path = splineThrough({{0, 0}, {4, 1}, {6, 5}, {1, 7}, {-3, 2}}, true),
                          .timing = {.speed = 3},
                          .repeat = PathRepeat::Loop});
    double time = 0;
    BENCHMARK("1,000 places along a spline") {
        double sum = 0;
        for (int i = 0; i < 1000; ++i) sum += lift.at(time += 1.0 / 60).position.x();
        return sum;
    };
}
