// SPDX-License-Identifier: MIT
// Which shapes are tile maps, and which of their tiles was met?
#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/shapes/tile_map.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// A shape that is a tile map: its definition, and the pieces in the space of each block of its cells.
struct TileShape {
    ShapeDef def;                                                ///< with the present map
    std::map<std::pair<int, int>, std::vector<ProxyId>> blocks;  ///< by row and column of the block

    const TileMap& map() const { return std::get<TileMap>(def.shape); }
};

/// The tile maps of all bodies, by body and number of the shape.
using TileStore = std::map<std::pair<BodyIndex, std::uint32_t>, TileShape>;

/// Where two shapes have met.
struct MetTile {
    ProxyId proxyA = 0, proxyB = 0;
    Vec2 shift{0, 0};   ///< of B, in a world that wraps [m]
    Vec2 point{0, 0};   ///< at A's image [m]
    Vec2 normal{0, 1};  ///< from A to B
};

/// The cell of a tile map that was met at a point of the world, given the piece that was met. Empty for any other
/// shape.
std::optional<Cell> tileMet(const TileStore& tiles, const BodyStore& bodies, const Space& space, ProxyId piece,
                            const Vec2& point, const Vec2& normal);
/// The cell of a tile map at which two shapes touch, if one of them is a map.
std::optional<Cell> tileTouched(const TileStore& tiles, const BodyStore& bodies, const Space& space,
                                const MetTile& where);

}  // namespace plumb
