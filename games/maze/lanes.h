// SPDX-License-Identifier: MIT
// How far is it from cell to cell through the maze, and which ways lead on?
#pragma once
#include <vector>

#include <games/maze/layout.h>

namespace plumb::games::maze {

/// All ways of the maze, found once by breadth-first search from every cell.
class Lanes {
public:
    Lanes();

    const std::vector<Cell>& cells() const { return cells_; }  ///< all that the player may enter
    /// In tiles, through the tunnel where that is nearer. Both must be lanes.
    int distance(Cell a, Cell b) const { return distances_[at(a) * cells_.size() + at(b)]; }
    const std::vector<Direction>& exits(Cell cell) const { return exits_[at(cell)]; }

private:
    std::size_t at(Cell cell) const { return index_[static_cast<std::size_t>(cell.row * columns + cell.column)]; }
    void measureFrom(Cell start);

    std::vector<Cell> cells_;
    std::vector<std::size_t> index_;
    std::vector<std::vector<Direction>> exits_;
    std::vector<int> distances_;
};

const Lanes& lanes();

}  // namespace plumb::games::maze
