// SPDX-License-Identifier: MIT
#include <compare/engine/outline.h>

#include <fmt/format.h>

#include <compare/engine/engine.h>

namespace plumb::compare {

std::vector<Polygon> tilePolygons(const TileMap& map, const std::string& body) {
    std::vector<Polygon> polygons;
    for (int row = 0; row < map.rows(); ++row) {
        for (int column = 0; column < map.columns(); ++column) {
            const Tile tile = map.at({column, row});
            if (isEmpty(tile)) continue;
            if (!isSolid(tile))
                throw Unsupported(fmt::format("body {}: tiles that are sensors or solid one way are not given", body));
            polygons.push_back({map.cornersOf({column, row})});
        }
    }
    return polygons;
}

}  // namespace plumb::compare
