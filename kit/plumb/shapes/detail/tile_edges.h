// SPDX-License-Identifier: MIT
// Which edges of a cell's tile are not covered by a neighbouring tile, and where does the outline continue?
#pragma once
#include <optional>
#include <vector>

#include <plumb/shapes/tile_map.h>

namespace plumb {

/// A point of the grid of half cells: all corners of tiles are such points.
struct HalfPoint {
    int x = 0, y = 0;
    friend bool operator==(const HalfPoint&, const HalfPoint&) = default;
};

/// The filled area is on its left.
struct TileEdge {
    HalfPoint start, end;
    TileKind kind = TileKind::Solid;
    Cell cell;  ///< the cell of the tile
    friend bool operator==(const TileEdge&, const TileEdge&) = default;
};

/// The edges of one cell's tile; those on the cell's sides are at most half a cell long, so that they match those of
/// neighbours.
std::vector<TileEdge> openEdges(const TileMap& map, Cell cell);

/// The next edge of the outline, or the previous one. Where several tiles touch in one point, the turn that keeps the
/// solid tiles connected, so that nothing passes between them. A one-way top is part of the outline of the solid tiles
/// beside it only where it is collinear.
std::optional<TileEdge> edgeAfter(const TileMap& map, const TileEdge& edge);
std::optional<TileEdge> edgeBefore(const TileMap& map, const TileEdge& edge);

/// The one-way top that, where a solid edge ends or starts at a convex corner, is collinear with the next edge around
/// that corner. A body that stands on it moves straight on over the corner, and must not collide with the edge below.
std::optional<TileEdge> topOverEnd(const TileMap& map, const TileEdge& edge);
std::optional<TileEdge> topOverStart(const TileMap& map, const TileEdge& edge);

}  // namespace plumb
