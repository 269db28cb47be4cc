// SPDX-License-Identifier: MIT
// Which cells may a grid mover enter?
#pragma once
#include <cstdint>

#include <plumb/movers/grid_direction.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// May what heads there enter a cell that holds this tile? A pure function of its arguments.
using PassRule = bool (*)(const Tile& tile, Direction heading);

/// What is a wall to a mover: a tile that is solid (see isSolid), but for those whose tag shares a bit with opens, and
/// those that share one with closes, solid or not; a rule, where there is one, says it all instead. So a door of tag 1
/// lets in those alone whose opens has bit 1. Beyond the edges of a map that does not wrap, all is wall.
struct GridPass {
    std::uint32_t opens = 0, closes = 0;
    PassRule rule = nullptr;
};

bool mayEnter(const GridPass& pass, const Tile& tile, Direction heading);

/// Is the next cell in this direction one of the map, and may it be entered?
bool isOpen(const TileMap& map, Cell cell, Direction direction, const GridPass& pass = {});

}  // namespace plumb
