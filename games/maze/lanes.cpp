// SPDX-License-Identifier: MIT
#include <games/maze/lanes.h>

namespace plumb::games::maze {

Lanes::Lanes() : index_(static_cast<std::size_t>(columns) * rows, 0) {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (!isLane({column, row})) continue;
            index_[static_cast<std::size_t>(row * columns + column)] = cells_.size();
            cells_.push_back({column, row});
        }
    for (const Cell cell : cells_) {
        exits_.emplace_back();
        for (const Direction direction : allDirections)
            if (isOpen(mazeMap(), cell, direction)) exits_.back().push_back(direction);
    }
    distances_.assign(cells_.size() * cells_.size(), -1);
    for (const Cell cell : cells_) measureFrom(cell);
}

void Lanes::measureFrom(Cell start) {
    int* const row = &distances_[at(start) * cells_.size()];
    std::vector<Cell> reached{start};
    row[at(start)] = 0;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const Cell cell = reached[next];
        for (const Direction exit : exits(cell)) {
            const Cell beyond = mazeMap().wrapped(neighbourOf(cell, exit));
            if (row[at(beyond)] >= 0) continue;
            row[at(beyond)] = row[at(cell)] + 1;
            reached.push_back(beyond);
        }
    }
}

const Lanes& lanes() {
    static const Lanes all;
    return all;
}

}  // namespace plumb::games::maze
