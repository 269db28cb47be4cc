// SPDX-License-Identifier: MIT
#include <plumb/shapes/tile_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <plumb/math/check.h>
#include <plumb/shapes/detail/checks.h>

namespace plumb {

namespace {

int wrappedInto(int index, int count) {
    const int rest = index % count;
    return rest < 0 ? rest + count : rest;
}

int flooredIndex(double value) {
    constexpr double most = std::numeric_limits<int>::max();
    return std::isnan(value) ? 0 : static_cast<int>(std::clamp(std::floor(value), -most, most));
}

std::string textOf(Cell cell) {
    return "(" + std::to_string(cell.column) + ", " + std::to_string(cell.row) + ")";
}

}  // namespace

TileMap::TileMap(const TileMapDef& def) : def_(def) {
    requireNumbers(def);
    const std::int64_t cells = std::int64_t{def.columns} * def.rows;
    if (cells > maxTileCells) refuse("TileMapDef", std::to_string(cells) + " cells are more than 2^24");
    requireFinite(def.size * std::max(def.columns, def.rows), "TileMapDef.size, times columns and rows");
    tiles_.resize(static_cast<std::size_t>(cells));
}

Cell TileMap::wrapped(Cell cell) const {
    return {def_.wrapX ? wrappedInto(cell.column, def_.columns) : cell.column,
            def_.wrapY ? wrappedInto(cell.row, def_.rows) : cell.row};
}

bool TileMap::contains(Cell cell) const {
    const Cell inside = wrapped(cell);
    return inside.column >= 0 && inside.column < def_.columns && inside.row >= 0 && inside.row < def_.rows;
}

std::size_t TileMap::indexOf(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(def_.columns) +
           static_cast<std::size_t>(cell.column);
}

Tile TileMap::at(Cell cell) const {
    return contains(cell) ? tiles_[indexOf(wrapped(cell))] : Tile{};
}

void TileMap::set(Cell cell, const Tile& tile) {
    if (!contains(cell))
        refuse("TileMap.set: cell", textOf(cell) + " is not one of " + std::to_string(def_.columns) + " columns and " +
                                        std::to_string(def_.rows) + " rows");
    tiles_[indexOf(wrapped(cell))] = tile;
}

TileMap TileMap::wrapping(bool x, bool y) const {
    TileMap map = *this;
    map.def_.wrapX = x;
    map.def_.wrapY = y;
    return map;
}

Cell TileMap::cellAt(const Vec2& point) const {
    return {flooredIndex(point.x() / def_.size), flooredIndex(point.y() / def_.size)};
}

std::vector<Vec2> TileMap::cornersOf(Cell cell) const {
    std::vector<Vec2> corners = plumb::cornersOf(at(cell));
    for (Vec2& corner : corners) corner = {(cell.column + corner.x()) * def_.size, (cell.row + corner.y()) * def_.size};
    return corners;
}

std::array<Vec2, 4> outerCornersOf(const TileMap& map) {
    const double width = map.columns() * map.size(), height = map.rows() * map.size();
    return {Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height)};
}

bool operator==(const TileMap& a, const TileMap& b) {
    const auto sameDef = [](const TileMapDef& x, const TileMapDef& y) {
        return x.columns == y.columns && x.rows == y.rows && x.size == y.size && x.wrapX == y.wrapX &&
               x.wrapY == y.wrapY;
    };
    return sameDef(a.def_, b.def_) && a.tiles_ == b.tiles_;
}

}  // namespace plumb
