// SPDX-License-Identifier: MIT
// Which cells of a grid are filled, and with what?
#pragma once
#include <array>
#include <vector>

#include <plumb/shapes/tile.h>

namespace plumb {

/// A cell of a grid: columns count to the right, rows upward, both from 0.
struct Cell {
    int column = 0;
    int row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
};

inline constexpr int maxTileCells = 1 << 24;

struct TileMapDef {
    int columns = 1, rows = 1;  ///< >= 1, at most 2^24 cells together
    double size = 1;            ///< of a cell, > 0 [m]
    bool wrapX = false;         ///< beyond its right edge it goes on at its left
    bool wrapY = false;         ///< beyond its top it goes on at its bottom
};

/// A grid of tiles whose lower left corner is the frame's origin. As a shape it is one collider: its inner edges are
/// gone, and nothing catches where two tiles meet.
class TileMap {
public:
    /// Empty. Throws std::invalid_argument naming the field.
    explicit TileMap(const TileMapDef& def = {});

    const TileMapDef& def() const { return def_; }
    int columns() const { return def_.columns; }
    int rows() const { return def_.rows; }
    double size() const { return def_.size; }  ///< of a cell [m]

    /// Where the map wraps, the cell of it that stands for this one.
    Cell wrapped(Cell cell) const;
    bool contains(Cell cell) const;  ///< after it was wrapped
    /// Empty outside of the map.
    Tile at(Cell cell) const;
    /// Throws std::invalid_argument when the map does not contain the cell.
    void set(Cell cell, const Tile& tile);

    /// The same tiles, on a map that wraps so.
    TileMap wrapping(bool x, bool y) const;

    /// The cell in which a point lies, also outside of the map, not wrapped; on an edge the one to the right and above.
    /// Coordinates are cut to what an int holds, and 0 where they are no number.
    Cell cellAt(const Vec2& point) const;
    Vec2 lowerLeft(Cell cell) const { return {cell.column * def_.size, cell.row * def_.size}; }                 ///< [m]
    Vec2 centerOf(Cell cell) const { return {(cell.column + 0.5) * def_.size, (cell.row + 0.5) * def_.size}; }  ///< [m]
    /// The outline of what fills a cell, in the map's frame, counter-clockwise [m].
    std::vector<Vec2> cornersOf(Cell cell) const;

    friend bool operator==(const TileMap& a, const TileMap& b);

private:
    std::size_t indexOf(Cell cell) const;

    TileMapDef def_;
    std::vector<Tile> tiles_;  ///< row by row from below
};

/// Of the whole grid, counter-clockwise from the origin, in the map's frame [m].
std::array<Vec2, 4> outerCornersOf(const TileMap& map);

}  // namespace plumb
