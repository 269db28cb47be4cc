// SPDX-License-Identifier: MIT
// Which cells of a grid are filled, and with which tiles?
#pragma once
#include <array>
#include <vector>

#include <plumb/math/overload.h>
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
    bool wrapX = false;         ///< periodic in x: right of its right edge it continues at its left edge
    bool wrapY = false;         ///< periodic in y: above its top it continues at its bottom
};

/// A grid of tiles whose lower left corner is the origin of the frame. As a shape it is one collider: edges between
/// solid tiles are removed, and nothing catches where two tiles meet.
class TileMap {
public:
    /// An empty map. Throws std::invalid_argument naming the field.
    explicit TileMap(const TileMapDef& def = {});
    explicit TileMap(detail::EmptyBraces) : TileMap() {}

    const TileMapDef& def() const { return def_; }
    int columns() const { return def_.columns; }
    int rows() const { return def_.rows; }
    double size() const { return def_.size; }  ///< of a cell [m]

    /// Where the map wraps, the cell within the map that is equivalent to this one.
    Cell wrapped(Cell cell) const;
    bool contains(Cell cell) const;  ///< after wrapping
    /// An empty tile outside of the map.
    Tile at(Cell cell) const;
    /// Throws std::invalid_argument when the map does not contain the cell.
    void set(Cell cell, const Tile& tile);

    /// A copy of the map that wraps in x, in y, or in both.
    TileMap wrapping(bool x, bool y) const;

    /// The cell that contains a point, also outside of the map, not wrapped; for a point on an edge, the cell to the
    /// right and above. Coordinates are limited to the range of int, and NaN gives 0.
    Cell cellAt(const Vec2& point) const;
    Vec2 lowerLeft(Cell cell) const { return {cell.column * def_.size, cell.row * def_.size}; }                 ///< [m]
    Vec2 centerOf(Cell cell) const { return {(cell.column + 0.5) * def_.size, (cell.row + 0.5) * def_.size}; }  ///< [m]
    /// The outline of the filled area of a cell, in the map's frame, counter-clockwise [m].
    std::vector<Vec2> cornersOf(Cell cell) const;

    friend bool operator==(const TileMap& a, const TileMap& b);

private:
    std::size_t indexOf(Cell cell) const;

    TileMapDef def_;
    std::vector<Tile> tiles_;  ///< row by row, starting at the bottom
};

/// The corners of the whole grid, counter-clockwise from the origin, in the map's frame [m].
std::array<Vec2, 4> outerCornersOf(const TileMap& map);

}  // namespace plumb
