// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <games/runner/draw.h>

namespace plumb::games::runner {

void drawWater(Canvas& canvas, const Scene& scene) {
    const TileMap& tiles = scene.stage.tiles();
    const Aabb seen = canvas.visible();
    const Cell first = tiles.cellAt(seen.lower), last = tiles.cellAt(seen.upper);
    const auto isWater = [&](int column, int row) {
        const Tile tile = tiles.at({column, row});
        return !isEmpty(tile) && tile.kind == TileKind::Sensor;
    };
    for (int row = std::max(0, first.row); row <= last.row; ++row)
        for (int column = first.column; column <= last.column; ++column) {
            if (!isWater(column, row)) continue;
            const int begin = column;
            while (isWater(column, row)) ++column;
            std::vector<Vec2> surface;
            for (double x = begin; x <= column + 1e-9; x += 0.125)
                surface.emplace_back(x, row + 0.74 + 0.06 * std::sin(2.4 * x + 2.2 * scene.time) +
                                            0.04 * std::sin(5.1 * x - 3.1 * scene.time));
            std::vector<Vec2> body = surface;
            body.emplace_back(column, std::min<double>(row, seen.lower.y()));
            body.emplace_back(begin, std::min<double>(row, seen.lower.y()));
            const Color color = scene.palette.water;
            canvas.polygon(std::move(body),
                           Paint::linear({0, row + 0.8}, color.faded(0.85), {0, row - 1.0}, darker(color, 0.5)));
            canvas.polyline(std::move(surface), lighter(color, 0.55).faded(0.9), 0.07);
        }
}

}  // namespace plumb::games::runner
