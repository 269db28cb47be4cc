// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/tile_edges.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

struct HalfEdge {
    HalfPoint start, end;
    friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

HalfPoint halfPointAt(Cell cell, const Vec2& corner) {
    return {2 * cell.column + static_cast<int>(2 * corner.x()), 2 * cell.row + static_cast<int>(2 * corner.y())};
}

bool isUpright(const HalfEdge& edge) {
    return edge.start.x == edge.end.x || edge.start.y == edge.end.y;
}

using HalfEdges = ShortList<HalfEdge, mostTileEdges>;

/// The edges of a tile in the cell (0, 0); edges on the cell's sides are split in halves.
HalfEdges edgesOfTile(const Tile& tile) {
    constexpr Cell cell{0, 0};
    const std::vector<Vec2> corners = cornersOf(tile);
    HalfEdges edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const HalfPoint a = halfPointAt(cell, corners[i]), b = halfPointAt(cell, corners[(i + 1) % corners.size()]);
        const HalfPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const bool long_ = isUpright({a, b}) && std::abs(a.x - b.x) + std::abs(a.y - b.y) == 2;
        if (!long_) {
            edges.push_back({a, b});
            continue;
        }
        edges.push_back({a, middle});
        edges.push_back({middle, b});
    }
    return edges;
}

/// The same, worked out once for each form.
const HalfEdges& edgesAround(const Tile& tile) {
    constexpr std::size_t forms = 8;
    static const auto ofForms = [] {
        std::array<std::array<HalfEdges, forms>, 2> edges;
        for (std::size_t form = 0; form < forms; ++form)
            for (const bool upsideDown : {false, true})
                edges[upsideDown][form] = edgesOfTile({.form = static_cast<TileForm>(form), .upsideDown = upsideDown});
        return edges;
    }();
    return ofForms[tile.upsideDown][static_cast<std::size_t>(tile.form)];
}

HalfEdge placedAt(Cell cell, const HalfEdge& edge) {
    const int x = 2 * cell.column, y = 2 * cell.row;
    return {{edge.start.x + x, edge.start.y + y}, {edge.end.x + x, edge.end.y + y}};
}

/// The cell on the other side of an edge that lies on a side of this cell.
Cell cellBeyond(const HalfEdge& edge, Cell cell) {
    const int dx = edge.end.x - edge.start.x, dy = edge.end.y - edge.start.y;
    return {cell.column + (dy > 0) - (dy < 0), cell.row + (dx < 0) - (dx > 0)};
}

bool isOnSide(const HalfEdge& edge, Cell cell) {
    const auto at = [](int a, int b, int side) { return a == side && b == side; };
    return at(edge.start.x, edge.end.x, 2 * cell.column) || at(edge.start.x, edge.end.x, 2 * cell.column + 2) ||
           at(edge.start.y, edge.end.y, 2 * cell.row) || at(edge.start.y, edge.end.y, 2 * cell.row + 2);
}

bool isCovered(const TileMap& map, const HalfEdge& edge, Cell cell) {
    if (!isOnSide(edge, cell)) return false;
    const Cell beyond = cellBeyond(edge, cell);
    const Tile tile = map.at(beyond);
    if (!isSolid(tile)) return false;
    if (tile.form == TileForm::Full) return true;
    const HalfEdges& there = edgesAround(tile);
    const HalfEdge back{edge.end, edge.start};
    return std::any_of(there.begin(), there.end(), [&](const HalfEdge& e) { return placedAt(beyond, e) == back; });
}

int crossOf(const TileEdge& a, const TileEdge& b) {
    return (a.end.x - a.start.x) * (b.end.y - b.start.y) - (a.end.y - a.start.y) * (b.end.x - b.start.x);
}

int dot(const TileEdge& a, const TileEdge& b) {
    return (a.end.x - a.start.x) * (b.end.x - b.start.x) + (a.end.y - a.start.y) * (b.end.y - b.start.y);
}

/// Grows with the left turn from one edge to the next, from -1 for a reversal to the right up to 1.
double turnBetween(const TileEdge& from, const TileEdge& to) {
    const double c = dot(from, to), s = crossOf(from, to);
    const double cosine = c / std::sqrt(c * c + s * s);
    return s < 0 || (s == 0 && c < 0) ? (cosine - 1) / 2 : (1 - cosine) / 2;
}

/// The open edges of a cell's tile for which fits is true, which is asked first, because it costs less.
template <class Fits, class Visit>
void forEachOpenEdge(const TileMap& map, Cell cell, Fits&& fits, Visit&& visit) {
    const Tile tile = map.at(cell);
    if (isEmpty(tile) || tile.kind == TileKind::Sensor) return;
    for (const HalfEdge& local : edgesAround(tile)) {
        const HalfEdge edge = placedAt(cell, local);
        const bool top = edge.end.x < edge.start.x;
        if (tile.kind == TileKind::OneWay && !top) continue;
        const TileEdge found{edge.start, edge.end, tile.kind, cell};
        if (fits(found) && !isCovered(map, edge, cell)) visit(found);
    }
}

/// Edges at a point: of four cells, each of which has one edge that ends there, and one that starts there.
using EdgesAtPoint = ShortList<TileEdge, 4 * 2>;

/// All edges near a point for which fits is true.
template <class Fits>
EdgesAtPoint edgesAt(const TileMap& map, HalfPoint point, Fits&& fits) {
    const auto floored = [](int half) { return half >= 0 ? half / 2 : -((1 - half) / 2); };
    EdgesAtPoint found;
    for (int row = floored(point.y - 1); row <= floored(point.y); ++row)
        for (int column = floored(point.x - 1); column <= floored(point.x); ++column)
            forEachOpenEdge(map, {column, row}, fits, [&](const TileEdge& edge) { found.push_back(edge); });
    return found;
}

std::optional<TileEdge> firstOf(const EdgesAtPoint& edges) {
    return edges.empty() ? std::nullopt : std::optional(edges.front());
}

/// turn(edge) is the turn of the outline between the given edge and the candidate.
template <class Turn>
std::optional<TileEdge> chosen(const EdgesAtPoint& candidates, TileKind kind, Turn&& turn) {
    std::optional<TileEdge> best;
    const auto take = [&](const TileEdge& edge) {
        if (!best || turn(edge) < turn(*best)) best = edge;
    };
    const bool oneWay = kind == TileKind::OneWay;
    for (const TileEdge& edge : candidates)
        if (oneWay || edge.kind != TileKind::OneWay) take(edge);
    for (const TileEdge& edge : candidates)
        if (!oneWay && edge.kind == TileKind::OneWay && turn(edge) == 0) take(edge);
    return best;
}

}  // namespace

TileEdges openEdges(const TileMap& map, Cell cell) {
    TileEdges open;
    forEachOpenEdge(
        map, cell, [](const TileEdge&) { return true; }, [&](const TileEdge& edge) { open.push_back(edge); });
    return open;
}

std::optional<TileEdge> edgeAfter(const TileMap& map, const TileEdge& edge) {
    const auto starts = [&](const TileEdge& other) { return other.start == edge.end; };
    return chosen(edgesAt(map, edge.end, starts), edge.kind,
                  [&](const TileEdge& other) { return turnBetween(edge, other); });
}

std::optional<TileEdge> edgeBefore(const TileMap& map, const TileEdge& edge) {
    const auto ends = [&](const TileEdge& other) { return other.end == edge.start; };
    return chosen(edgesAt(map, edge.start, ends), edge.kind,
                  [&](const TileEdge& other) { return turnBetween(other, edge); });
}

std::optional<TileEdge> topOverEnd(const TileMap& map, const TileEdge& edge) {
    const std::optional<TileEdge> next = edgeAfter(map, edge);
    if (!next || edge.kind == TileKind::OneWay || next->kind == TileKind::OneWay || crossOf(edge, *next) <= 0)
        return {};
    return firstOf(edgesAt(map, edge.end, [&](const TileEdge& other) {
        return other.end == edge.end && other.kind == TileKind::OneWay && turnBetween(other, *next) == 0;
    }));
}

std::optional<TileEdge> topOverStart(const TileMap& map, const TileEdge& edge) {
    const std::optional<TileEdge> last = edgeBefore(map, edge);
    if (!last || edge.kind == TileKind::OneWay || last->kind == TileKind::OneWay || crossOf(*last, edge) <= 0)
        return {};
    return firstOf(edgesAt(map, edge.start, [&](const TileEdge& other) {
        return other.start == edge.start && other.kind == TileKind::OneWay && turnBetween(*last, other) == 0;
    }));
}

}  // namespace plumb
