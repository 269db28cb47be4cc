// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_choice.h>

namespace plumb {

namespace {

bool mayLeave(const TileMap& map, const GridCrossing& crossing, Direction exit) {
    if (exit == opposite(crossing.heading)) return false;
    if (exit == Direction::Up && crossing.upClosed) return false;
    return isOpen(map, crossing.cell, exit, crossing.pass);
}

/// In double: exact for maps of up to 2^24 cells, and without overflow for any cell.
double squaredDistance(Cell a, Cell b) {
    const double columns = static_cast<double>(a.column) - b.column, rows = static_cast<double>(a.row) - b.row;
    return columns * columns + rows * rows;
}

}  // namespace

std::optional<Direction> nextDirection(const TileMap& map, const GridCrossing& crossing, Cell target) {
    std::optional<Direction> best;
    double least = 0;
    for (const Direction exit : allDirections) {
        if (!mayLeave(map, crossing, exit)) continue;
        const double distance = squaredDistance(neighbourOf(crossing.cell, exit), target);
        if (best && distance >= least) continue;
        best = exit;
        least = distance;
    }
    return best;
}

std::optional<Direction> firstOpenClockwise(const TileMap& map, const GridCrossing& crossing, Direction wanted) {
    for (int turn = 0; turn < 4; ++turn, wanted = clockwise(wanted))
        if (mayLeave(map, crossing, wanted)) return wanted;
    return std::nullopt;
}

}  // namespace plumb
