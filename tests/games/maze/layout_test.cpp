// SPDX-License-Identifier: MIT
#include <games/maze/lanes.h>

#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::games::maze;

int count(TileTag tag) {
    int found = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) found += has(mazeMap().at({column, row}), tag) ? 1 : 0;
    return found;
}

}  // namespace

// The arcade's counters are made for 240 dots and 4 energizers.
TEST_CASE("the maze has 28 x 36 tiles, 240 dots and 4 power dots, all in lanes", "[games][maze]") {
    CHECK(mazeMap().columns() == 28);
    CHECK(mazeMap().rows() == 36);
    CHECK(count(dotTag) == 240);
    CHECK(count(powerTag) == 4);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            if ((mazeMap().at({column, row}).tag & (dotTag | powerTag)) != 0) CHECK(isLane({column, row}));
}

TEST_CASE("the right half of the maze is its left half mirrored, with its dots", "[games][maze]") {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns / 2; ++column) {
            CAPTURE(column, row);
            CHECK(mazeMap().at({column, row}) == mazeMap().at({columns - 1 - column, row}));
        }
}

TEST_CASE("every lane cell of the maze has at least two exits and can be reached from the player's start",
          "[games][maze]") {
    for (const Cell cell : lanes().cells()) {
        CAPTURE(cell.column, cell.row);
        CHECK(lanes().exits(cell).size() >= 2);
        CHECK(lanes().distance(playerStart.cell, cell) >= 0);
        CHECK(lanes().distance(cell, playerStart.cell) == lanes().distance(playerStart.cell, cell));
    }
}

TEST_CASE("lanes are one tile wide: no block of 2 x 2 cells of the maze is open", "[games][maze]") {
    for (const Cell cell : lanes().cells()) {
        const bool square = isLane({cell.column + 1, cell.row}) && isLane({cell.column, cell.row + 1}) &&
                            isLane({cell.column + 1, cell.row + 1});
        CAPTURE(cell.column, cell.row);
        CHECK_FALSE(square);
    }
}

TEST_CASE("the tunnel is in row 17 from above, and columns 5 and 22 are 11 tiles apart through it", "[games][maze]") {
    const int row = rows - 1 - 17;
    for (const int column : {0, 1, 2, 3, 4, 5, 22, 23, 24, 25, 26, 27}) CHECK(isLane({column, row}));
    CHECK(lanes().distance({0, row}, {27, row}) == 1);
    CHECK(lanes().distance({5, row}, {22, row}) == 11);
    for (int other = 0; other < rows; ++other) CHECK(isLane({0, other}) == (other == row));
}

TEST_CASE("each of the 4 cells that hunters may not leave upward has a lane above it", "[games][maze]") {
    CHECK(specialPlaces().upClosed.size() == 4);
    for (const Cell cell : specialPlaces().upClosed) {
        CHECK(isLane(cell));
        CHECK(isLane({cell.column, cell.row + 1}));
    }
    CHECK(isLane(specialPlaces().door));
}
