// SPDX-License-Identifier: MIT
// How does a body come to have a tile map for a shape, and how does the map change under what lies on it?
#pragma once
#include <map>
#include <utility>
#include <vector>

#include <plumb/dynamics/detail/body_store.h>
#include <plumb/shapes/tile_map.h>
#include <plumb/space/shape_def.h>

namespace plumb {

struct ContactRecord;
struct WorldState;

/// A tile map that is a shape: what was given, and which pieces of which block of cells are in the space for it.
struct TileShape {
    ShapeDef def;                                                ///< with the map as it is now
    std::map<std::pair<int, int>, std::vector<ProxyId>> blocks;  ///< by row and column of the block

    const TileMap& map() const { return std::get<TileMap>(def.shape); }
};

/// Of all bodies, by body and number of the shape.
using TileStore = std::map<std::pair<BodyIndex, std::uint32_t>, TileShape>;

/// def.shape is a tile map. It has a first piece that nothing meets, so that it is there when it is empty.
void addTiles(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Of a shape that is a tile map. Only pieces that the tile was or is a part of, or that end at it, come and go; what
/// touched those wakes.
void editTile(WorldState& world, BodyIndex body, std::uint32_t number, Cell cell, const Tile& tile);
/// What a piece has of the def of the whole, with its own shape and what its tiles' kind makes of it.
ShapeDef pieceOf(const ShapeDef& whole, const Proxy& piece);
/// The cell of a tile map that was met at a point of the world, through one of its pieces. None of another shape.
std::optional<Cell> tileMet(const WorldState& world, ProxyId piece, const Vec2& point, const Vec2& normal);
/// The cell of a tile map at which two shapes touch, if one of them is a map. The point is where A sees it, in a world
/// that wraps; the normal leads from A to B.
std::optional<Cell> tileTouched(const WorldState& world, const ContactRecord& contact, const Vec2& point,
                                const Vec2& normal);

}  // namespace plumb
