// SPDX-License-Identifier: MIT
// Which target does a hunter have, and which exit does it take, according to the source? The code uses the source's
// coordinates, and none of the kit's rules. Source: The Pac-Man Dossier, chapter 4.
#pragma once
#include <set>
#include <tuple>

#include <games/maze/chase.h>

namespace plumb::test {

using games::maze::Chase;
using games::maze::Who;

/// Columns from the left and rows from above, as in the source.
struct Spot {
    int column, row;
};
inline Spot spotOf(Cell cell) {
    return {cell.column, 35 - cell.row};
}
/// The source's way of adding n tiles in a direction: up is also to the left.
inline Spot plus(Spot spot, Direction heading, int n) {
    switch (heading) {
        case Direction::Up: return {spot.column - n, spot.row - n};
        case Direction::Left: return {spot.column - n, spot.row};
        case Direction::Down: return {spot.column, spot.row + n};
        case Direction::Right: break;
    }
    return {spot.column + n, spot.row};
}
inline int squared(Spot a, Spot b) {
    return (a.column - b.column) * (a.column - b.column) + (a.row - b.row) * (a.row - b.row);
}

inline Spot targetByTheBook(const Chase& chase, Who who, Cell from, bool rests) {
    const Spot corners[]{{25, 0}, {2, 0}, {27, 35}, {0, 35}};
    if (rests) return corners[indexOf(who)];
    const Spot player = spotOf(chase.player().cell());
    const Direction heading = chase.player().heading();
    if (who == Who::Chaser) return player;
    if (who == Who::Ambusher) return plus(player, heading, 4);
    if (who == Who::Flanker) {
        const Spot two = plus(player, heading, 2), chaser = spotOf(chase.hunter(Who::Chaser).cell());
        return {2 * two.column - chaser.column, 2 * two.row - chaser.row};
    }
    return squared(spotOf(from), player) >= 64 ? player : corners[3];
}

/// The exit of this cell, which is the one after the cell just entered. Not a wall, not the way back; the least
/// distance to the target; equal ones in the order up, left, down, right; four tiles are not left upward.
inline Direction exitByTheBook(Cell cell, Direction heading, Spot target) {
    const std::set<std::tuple<int, int>> noUp{{12, 14}, {15, 14}, {12, 26}, {15, 26}};
    const std::tuple<Direction, int, int> ways[]{
        {Direction::Up, 0, -1}, {Direction::Left, -1, 0}, {Direction::Down, 0, 1}, {Direction::Right, 1, 0}};
    const Spot at = spotOf(cell);
    Direction best = heading;
    int least = 1'000'000;
    for (const auto& [way, dx, dy] : ways) {
        const Spot next{at.column + dx, at.row + dy};
        const bool open = games::maze::isLane({(next.column + 28) % 28, 35 - next.row});
        if (!open || way == opposite(heading)) continue;
        if (way == Direction::Up && noUp.count({at.column, at.row}) > 0) continue;
        if (squared(next, target) >= least) continue;
        least = squared(next, target);
        best = way;
    }
    return best;
}

}  // namespace plumb::test
