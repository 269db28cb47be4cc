// SPDX-License-Identifier: MIT
// How does a body come to have a tile map for a shape, and how does the map change under what lies on it?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// def.shape is a tile map. It has a first piece that nothing meets, so that it is there when it is empty.
void addTiles(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Of a shape that is a tile map. Only pieces that the tile was or is a part of, or that end at it, come and go; what
/// touched those wakes.
void editTile(WorldState& world, BodyIndex body, std::uint32_t number, Cell cell, const Tile& tile);
/// What a piece has of the def of the whole, with its own shape and what its tiles' kind makes of it.
ShapeDef pieceOf(const ShapeDef& whole, const Proxy& piece);
}  // namespace plumb
