// SPDX-License-Identifier: MIT
// What do movers play in that is made of tiles, and what of it is in whose way?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/math/random.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/tile_text.h>

namespace plumb::test {

/// As a picture: rows of '#', '=', '^', '~', ramps of both kinds, walls, single tiles of any letter; closed below,
/// above and, where it does not go on at its other side, left and right.
inline std::vector<std::string> tileLevelText(Random& random, int columns, int rows, bool closed) {
    std::vector<std::string> text(static_cast<std::size_t>(rows), std::string(static_cast<std::size_t>(columns), '.'));
    const auto put = [&](int column, int row, const std::string& part) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const int at = column + static_cast<int>(i);
            if (at < columns && row >= 0 && row < rows)
                text[static_cast<std::size_t>(row)][static_cast<std::size_t>(at)] = part[i];
        }
    };
    const auto run = [&](char letter) { return std::string(static_cast<std::size_t>(random.integer(1, 9)), letter); };
    for (int n = 0; n < columns * rows / 24; ++n) {
        const int column = random.integer(0, columns - 1), row = random.integer(1, rows - 2);
        switch (random.integer(0, 8)) {
            case 0:
            case 1: put(column, row, run('#')); break;
            case 2: put(column, row, run('=')); break;
            case 3: put(column, row, run(random.integer(0, 1) == 0 ? '^' : '~')); break;
            case 4: put(column, row, "/" + run('#') + "\\"); break;
            case 5: put(column, row, "12" + run('#') + "34"); break;
            case 6:
                for (int i = 0; i < 4; ++i)
                    put(column + (3 - i), row - (3 - i), "/" + std::string(static_cast<std::size_t>(i), '#'));
                break;
            case 7:
                for (int i = 0; i < random.integer(2, 6); ++i) put(column, row + i, "#");
                break;
            default: put(column, row, std::string(1, "#=^~/\\1234"[random.integer(0, 9)]));
        }
    }
    text.front() = text.back() = std::string(static_cast<std::size_t>(columns), '#');
    for (std::string& line : text)
        if (closed) line.front() = line.back() = '#';
    return text;
}

/// The same tiles as a list of polygons, one a cell, without any of the kit's tricks.
struct BruteTiles {
    TileMap map;

    /// How deep a shape at a place is in any tile that stops from all sides; negative when it is clear [m].
    double depth(const Shape& shape, const Vec2& at) const {
        double deepest = -1e300;
        forCells(shape, at, [&](Cell cell, const Tile& tile) {
            if (isSolid(tile)) deepest = std::max(deepest, depthIn(cell, shape, at));
        });
        return deepest;
    }
    bool isFree(const Shape& shape, const Vec2& at) const { return depth(shape, at) < 0; }

    /// Is it clear all along the straight way there, looked at eight times?
    bool isFree(const Shape& shape, const Vec2& from, const Vec2& shift) const {
        for (int i = 1; i <= 8; ++i)
            if (!isFree(shape, from + i / 8.0 * shift)) return false;
        return true;
    }

    /// A full one-way tile over whose middle part the shape's lowest point was, and into which it has sunk since.
    std::optional<Cell> sunkInto(const Shape& shape, const Vec2& before, const Vec2& now) const {
        std::optional<Cell> found;
        forCells(shape, now, [&](Cell cell, const Tile& tile) {
            if (tile.kind != TileKind::OneWay || tile.form != TileForm::Full) return;
            const Vec2 low = map.lowerLeft(cell);
            const auto over = [&](double x) { return x > low.x() && x < low.x() + map.size(); };
            const double bottom = aabbOf(shape, {before, {}}).lower.y();
            if (over(before.x()) && over(now.x()) && bottom >= low.y() + map.size() - 1e-9 &&
                depthIn(cell, shape, now) > 1e-9)
                found = cell;
        });
        return found;
    }

    /// Can one come from cell to cell, up, down, left and right, without a full tile that stops from all sides?
    bool isWay(Cell from, Cell to) const {
        std::vector<Cell> open{map.wrapped(from)};
        std::vector<bool> seen(static_cast<std::size_t>(map.columns() * map.rows()));
        while (!open.empty()) {
            const Cell cell = map.wrapped(open.back());
            open.pop_back();
            if (!map.contains(cell)) continue;
            const auto index = static_cast<std::size_t>(cell.row * map.columns() + cell.column);
            if (seen[index] || (isSolid(map.at(cell)) && map.at(cell).form == TileForm::Full)) continue;
            if (cell == map.wrapped(to)) return true;
            seen[index] = true;
            for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                open.push_back({cell.column + x, cell.row + y});
        }
        return false;
    }

private:
    void forCells(const Shape& shape, const Vec2& at, const auto& visit) const {
        const Aabb box = inflate(aabbOf(shape, {at, {}}), 0.01);
        const Cell low = map.cellAt(box.lower), high = map.cellAt(box.upper);
        for (int row = low.row; row <= high.row; ++row)
            for (int column = low.column; column <= high.column; ++column)
                visit(Cell{column, row}, map.at({column, row}));
    }
    double depthIn(Cell cell, const Shape& shape, const Vec2& at) const {
        std::vector<Vec2> corners;
        for (const Vec2& corner : cornersOf(map.at(cell))) corners.push_back(map.lowerLeft(cell) + map.size() * corner);
        return -distance(Polygon{corners}, {}, shape, {at, {}}).separation;
    }
};

}  // namespace plumb::test
