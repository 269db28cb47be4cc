// SPDX-License-Identifier: MIT
#include <plumb/movers/grid_pass.h>

namespace plumb {

bool mayEnter(const GridPass& pass, const Tile& tile, Direction heading) {
    if (pass.rule) return pass.rule(tile, heading);
    if (tile.tag & pass.closes) return false;
    return !isSolid(tile) || (tile.tag & pass.opens);
}

bool isOpen(const TileMap& map, Cell cell, Direction direction, const GridPass& pass) {
    const Cell next = neighbourOf(cell, direction);
    return map.contains(next) && mayEnter(pass, map.at(next), direction);
}

}  // namespace plumb
