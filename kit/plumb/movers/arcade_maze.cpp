// SPDX-License-Identifier: MIT
#include <plumb/movers/arcade_maze.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <plumb/math/check.h>

namespace plumb {

namespace {

/// Rows counted from above, as in the sources.
Cell fromAbove(int column, int row) {
    return {column, ArcadeProfile{}.rows - 1 - row};
}

Cell ahead(Cell cell, Direction heading, int cells) {
    for (int i = 0; i < cells; ++i) cell = neighbourOf(cell, heading);
    if (heading == Direction::Up) cell.column -= cells;
    return cell;
}

bool isFar(Cell a, Cell b) {
    const double columns = static_cast<double>(a.column) - b.column, rows = static_cast<double>(a.row) - b.row;
    return columns * columns + rows * rows >= 8 * 8;
}

}  // namespace

ArcadeMaze arcadeMaze() {
    return {.slow = {{fromAbove(0, 17), fromAbove(5, 17)}, {fromAbove(22, 17), fromAbove(27, 17)}},
            .upClosed = {fromAbove(12, 14), fromAbove(15, 14), fromAbove(12, 26), fromAbove(15, 26)},
            .corners = {fromAbove(25, 0), fromAbove(2, 0), fromAbove(27, 35), fromAbove(0, 35)},
            .door = fromAbove(13, 14),
            .starts = {placeOfPixel(112, 116), placeOfPixel(112, 140), placeOfPixel(96, 140), placeOfPixel(128, 140)}};
}

bool isSlow(const ArcadeMaze& maze, Cell cell) {
    return std::any_of(maze.slow.begin(), maze.slow.end(), [&](const CellBlock& block) {
        return cell.column >= block.first.column && cell.column <= block.last.column && cell.row >= block.first.row &&
               cell.row <= block.last.row;
    });
}

bool isUpClosed(const ArcadeMaze& maze, Cell cell, bool frightened) {
    return !frightened && std::find(maze.upClosed.begin(), maze.upClosed.end(), cell) != maze.upClosed.end();
}

GridPlace placeOfPixel(int x, int y, const ArcadeProfile& profile) {
    if (profile.pixelsPerTile < 1)
        refuse("ArcadeProfile.pixelsPerTile", std::to_string(profile.pixelsPerTile) + " is not 1 or more");
    const double size = profile.pixelsPerTile;
    const double column = std::ceil(x / size) - 1, row = std::ceil((profile.rows * size - y) / size) - 1;
    return {{static_cast<int>(column), static_cast<int>(row)},
            {x / size - column - 0.5, (profile.rows * size - y) / size - row - 0.5}};
}

int hunterPercent(const ArcadeSpeeds& speeds, bool slow, bool frightened, int haste) {
    if (slow) return speeds.hunterTunnel;
    if (frightened && speeds.hunterFright > 0) return speeds.hunterFright;
    return haste == 0 ? speeds.hunter : haste == 1 ? speeds.haste1 : speeds.haste2;
}

Cell hunterTarget(int hunter, const HunterContext& context, const ArcadeMaze& maze) {
    switch (hunter) {
        case 0: return context.player;
        case 1: return ahead(context.player, context.heading, 4);
        case 2: {
            const Cell middle = ahead(context.player, context.heading, 2);
            return {2 * middle.column - context.chaser.column, 2 * middle.row - context.chaser.row};
        }
        case 3: return isFar(context.hunter, context.player) ? context.player : maze.corners[3];
        default: break;
    }
    refuse("hunterTarget: hunter", std::to_string(hunter) + " is not within 0 to 3");
}

}  // namespace plumb
