// SPDX-License-Identifier: MIT
// Through which mazes do the tests' movers go, and what do they do there?
#pragma once
#include <span>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/movers/grid_mover.h>

namespace plumb::test {

inline constexpr Tile wallTile{.form = TileForm::Full};
inline constexpr SpeedPattern onePixelAFrame{0x55555555};

inline TileMap filled(const TileMapDef& def) {
    TileMap map(def);
    for (int row = 0; row < def.rows; ++row)
        for (int column = 0; column < def.columns; ++column) map.set({column, row}, wallTile);
    return map;
}

/// One lane from left to right, or from below upward.
inline TileMap lane(bool horizontal, int length, bool wraps) {
    TileMap map = filled({.columns = horizontal ? length : 3,
                          .rows = horizontal ? 3 : length,
                          .wrapX = horizontal && wraps,
                          .wrapY = !horizontal && wraps});
    for (int i = 0; i < length; ++i) map.set(horizontal ? Cell{i, 1} : Cell{1, i}, {});
    return map;
}

/// Two lanes that cross in the middle of 9 x 9 cells, (4, 4).
inline TileMap crossOfLanes() {
    TileMap map = filled({.columns = 9, .rows = 9});
    for (int i = 0; i < 9; ++i) {
        map.set({i, 4}, {});
        map.set({4, i}, {});
    }
    return map;
}

/// Corridors dug by a random walk, some through the edges where it wraps; a part of the rest opened at random.
inline TileMap randomMaze(Random& random) {
    const TileMapDef def{.columns = random.integer(3, 20),
                         .rows = random.integer(3, 20),
                         .size = random.uniform(0.1, 10),
                         .wrapX = random.integer(0, 1) == 0,
                         .wrapY = random.integer(0, 1) == 0};
    TileMap map = filled(def);
    Cell at{random.integer(0, def.columns - 1), random.integer(0, def.rows - 1)};
    for (int dug = def.columns * def.rows; dug > 0; --dug) {
        map.set(at, {});
        const Cell next = neighbourOf(at, static_cast<Direction>(random.integer(0, 3)));
        if (map.contains(next)) at = map.wrapped(next);
    }
    return map;
}

/// The tests' own word on what is open: a table of walls, and remainders for the edges.
class OpenCells {
public:
    explicit OpenCells(const TileMap& map) : def_(map.def()) {
        for (int row = 0; row < def_.rows; ++row)
            for (int column = 0; column < def_.columns; ++column) open_.push_back(map.at({column, row}) == Tile{});
    }
    bool at(Cell cell) const {
        if (def_.wrapX) cell.column = (cell.column + def_.columns) % def_.columns;
        if (def_.wrapY) cell.row = (cell.row + def_.rows) % def_.rows;
        const bool inside = cell.column >= 0 && cell.column < def_.columns && cell.row >= 0 && cell.row < def_.rows;
        return inside && open_[static_cast<std::size_t>(cell.row * def_.columns + cell.column)];
    }
    /// One step of an int, in each direction by its name.
    Cell next(Cell cell, Direction direction) const {
        switch (direction) {
            case Direction::Up: return {cell.column, cell.row + 1};
            case Direction::Down: return {cell.column, cell.row - 1};
            case Direction::Left: return {cell.column - 1, cell.row};
            case Direction::Right: break;
        }
        return {cell.column + 1, cell.row};
    }
    Cell wrapped(Cell cell) const {
        return {def_.wrapX ? (cell.column + def_.columns) % def_.columns : cell.column,
                def_.wrapY ? (cell.row + def_.rows) % def_.rows : cell.row};
    }
    bool ahead(Cell cell, Direction direction) const { return at(next(cell, direction)); }

private:
    TileMapDef def_;
    std::vector<bool> open_;
};

inline int count(std::span<const GridEvent> events, GridEventKind kind) {
    int found = 0;
    for (const GridEvent& event : events) found += event.kind == kind ? 1 : 0;
    return found;
}

}  // namespace plumb::test
