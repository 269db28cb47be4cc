// SPDX-License-Identifier: MIT
// Which edges of a cell's tile are not covered by a neighbouring tile, and where does the outline continue?
#pragma once
#include <array>
#include <cstddef>
#include <optional>

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

/// A short list without heap memory: a large map has millions of edges, each looked at several times.
template <class T, std::size_t Most>
class ShortList {
public:
    void push_back(const T& item) { items_[size_++] = item; }
    const T* begin() const { return items_.data(); }
    const T* end() const { return items_.data() + size_; }
    bool empty() const { return size_ == 0; }
    const T& front() const { return items_[0]; }

private:
    std::array<T, Most> items_{};
    std::size_t size_ = 0;
};

/// A full tile has two on each side, and no other form has more.
inline constexpr std::size_t mostTileEdges = 8;
using TileEdges = ShortList<TileEdge, mostTileEdges>;

/// The edges of one cell's tile; those on the cell's sides are at most half a cell long, so that they match those of
/// neighbours.
TileEdges openEdges(const TileMap& map, Cell cell);

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
