// SPDX-License-Identifier: MIT
// How is a tile map added to a body as a shape, and how does it change while bodies lie on it?
#pragma once
#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// Adds a shape whose def.shape is a tile map. Its first piece touches nothing, so that even an empty map has a piece.
void addTiles(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Changes a tile of a shape that is a tile map. Replaces only the pieces that the tile was or is a part of, or that
/// end at it; bodies that touched these pieces wake.
void editTile(WorldState& world, BodyIndex body, std::uint32_t number, Cell cell, const Tile& tile);
/// The definition of one piece: that of the whole shape, with the piece's own shape and the properties of its tiles'
/// kind.
ShapeDef pieceOf(const ShapeDef& whole, const Proxy& piece);
}  // namespace plumb
