// SPDX-License-Identifier: MIT
// What does the source say that a hunter makes for, and how it gets there? Told in its own way of counting, and without
// the kit's rules. Source: The Pac-Man Dossier, chapter 4.
#pragma once
#include <set>
#include <tuple>

#include <games/maze/chase.h>

namespace plumb::test {

using games::maze::Chase;
using games::maze::Who;

/// Columns, and rows from above, as the source counts them.
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

/// Of the cell that comes after the one it has just entered: walls and the way back dropped, the least distance, ties
/// by up, left, down, right; four tiles are not left upward.
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
