// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_probe.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace plumb::detail {

namespace {

/// In half cells, from the cell's lower side: the ends of a tile's top are always multiples of this.
struct TopEnds {
    int left = 0, right = 0;
};

bool isFloor(const TileMap& map, Cell cell) {
    const Tile tile = map.at(cell);
    return !isEmpty(tile) && tile.kind == TileKind::OneWay;
}

TopEnds topOf(const Tile& tile) {
    TopEnds top;
    for (const Vec2& corner : cornersOf(tile)) {
        int& end = corner.x() < 0.5 ? top.left : top.right;
        end = std::max(end, static_cast<int>(2 * corner.y()));
    }
    return top;
}

/// A point on a slope may be assigned to the cell above or below.
Cell floorNear(const TileMap& map, Cell cell) {
    for (const int up : {0, -1, 1})
        if (isFloor(map, {cell.column, cell.row + up})) return {cell.column, cell.row + up};
    return cell;
}

/// How many columns to the right; on a map that wraps, in the shorter direction.
int columnsBetween(const TileMap& map, Cell from, Cell to) {
    const int columns = to.column - from.column, around = map.columns();
    if (!map.def().wrapX || 2 * std::abs(columns) <= around) return columns;
    return columns < 0 ? columns + around : columns - around;
}

/// The rows in the next column whose tops continue those of these rows.
std::vector<int> rowsBeside(const TileMap& map, int column, const std::vector<int>& rows, bool toRight) {
    std::vector<int> beside;
    for (const int row : rows) {
        const TopEnds top = topOf(map.at({column, row}));
        const int end = 2 * row + (toRight ? top.right : top.left);
        for (int other = row - 1; other <= row + 1; ++other) {
            const Cell cell{column + (toRight ? 1 : -1), other};
            if (!isFloor(map, cell)) continue;
            const TopEnds next = topOf(map.at(cell));
            const bool known = std::find(beside.begin(), beside.end(), other) != beside.end();
            if (2 * other + (toRight ? next.left : next.right) == end && !known) beside.push_back(other);
        }
    }
    return beside;
}

bool isOneRow(const TileMap& map, Cell from, Cell to) {
    from = floorNear(map, from);
    to = floorNear(map, to);
    const int columns = columnsBetween(map, from, to), step = columns < 0 ? -1 : 1;
    std::vector<int> rows{from.row};
    for (int i = 0; i != columns && !rows.empty(); i += step)
        rows = rowsBeside(map, from.column + i, rows, columns > 0);
    return std::any_of(rows.begin(), rows.end(), [&](int row) {
        return map.wrapped({to.column, row}).row == map.wrapped(to).row;
    });
}

}  // namespace

std::optional<Vec2> openSideOf(const CastHit& hit) {
    if (!hit.oneWay) return std::nullopt;
    return Vec2(*hit.oneWay / std::sqrt(hit.oneWay->dot(*hit.oneWay)));
}

const TileMap* mapOf(const World& world, const ShapeId& shape) {
    try {
        return &world.tiles(shape);
    } catch (const std::invalid_argument&) {
        return nullptr;
    }
}

bool isOneFloor(const World& world, const OneWayFloor& a, const OneWayFloor& b) {
    if (!(a.shape == b.shape)) return false;
    if (!a.tile || !b.tile || *a.tile == *b.tile) return true;
    const TileMap* map = mapOf(world, a.shape);
    return map == nullptr || isOneRow(*map, *a.tile, *b.tile);
}

}  // namespace plumb::detail
