// SPDX-License-Identifier: MIT
// Which cells may a grid mover enter?
#pragma once
#include <cstdint>

#include <plumb/movers/grid_direction.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// May a mover with this heading enter a cell with this tile? A pure function of its arguments.
using PassRule = bool (*)(const Tile& tile, Direction heading);

/// Which tiles are walls for a mover: solid tiles (see isSolid), except those whose tag shares a bit with opens; and
/// tiles whose tag shares a bit with closes, solid or not. A rule, if there is one, replaces all this. So a door with
/// tag 1 lets only movers pass whose opens has bit 1. Outside of a map that does not wrap, everything is wall.
struct GridPass {
    std::uint32_t opens = 0, closes = 0;
    PassRule rule = nullptr;
};

inline bool mayEnter(const GridPass& pass, const Tile& tile, Direction heading) {
    if (pass.rule) return pass.rule(tile, heading);
    if (tile.tag & pass.closes) return false;
    return !isSolid(tile) || (tile.tag & pass.opens);
}

/// Is the next cell in this direction on the map, and may it be entered?
inline bool isOpen(const TileMap& map, Cell cell, Direction direction, const GridPass& pass = {}) {
    const Cell next = neighbourOf(cell, direction);
    return map.contains(next) && mayEnter(pass, map.at(next), direction);
}

}  // namespace plumb
