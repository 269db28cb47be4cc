// SPDX-License-Identifier: MIT
// Which edges of a cell's tile are not covered by the tile beside it, and where does the outline go on?
#pragma once
#include <optional>
#include <vector>

#include <plumb/shapes/tile_map.h>

namespace plumb {

/// A point of the grid of half cells: no tile has a corner anywhere else.
struct HalfPoint {
    int x = 0, y = 0;
    friend bool operator==(const HalfPoint&, const HalfPoint&) = default;
};

/// Has what is filled on its left.
struct TileEdge {
    HalfPoint start, end;
    TileKind kind = TileKind::Solid;
    Cell cell;  ///< whose it is
    friend bool operator==(const TileEdge&, const TileEdge&) = default;
};

/// Of a cell's tile, at most half a cell long where they lie on its sides, so that those of neighbours match.
std::vector<TileEdge> openEdges(const TileMap& map, Cell cell);

/// Where the outline goes on after an edge, or came from before it. Where several tiles touch in one point, the way
/// that keeps them together: what is solid there can be passed by nothing. A one-way top is part of the outline of what
/// is solid beside it only where it lies in line.
std::optional<TileEdge> edgeAfter(const TileMap& map, const TileEdge& edge);
std::optional<TileEdge> edgeBefore(const TileMap& map, const TileEdge& edge);

/// The one-way top that, where a solid edge ends or starts at a convex corner, lies in line with the edge around that
/// corner. Who stands on it goes straight on over the corner, and must not feel the edge below it.
std::optional<TileEdge> topOverEnd(const TileMap& map, const TileEdge& edge);
std::optional<TileEdge> topOverStart(const TileMap& map, const TileEdge& edge);

}  // namespace plumb
