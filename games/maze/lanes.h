// SPDX-License-Identifier: MIT
// How long is the way from one cell of the maze to another, and which exits does a cell have?
#pragma once
#include <vector>

#include <games/maze/layout.h>

namespace plumb::games::maze {

/// The distances between all cells, found once by breadth-first search from every cell.
class Lanes {
public:
    Lanes();

    const std::vector<Cell>& cells() const { return cells_; }  ///< all cells that the player may enter
    /// The shortest way, through the tunnel if that is shorter [tiles]. Both cells must be lanes.
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
