// SPDX-License-Identifier: MIT
#include <plumb/shapes/tile_pieces.h>

#include <algorithm>

#include <plumb/shapes/detail/tile_edges.h>

namespace plumb {

namespace {

Cell blockOf(Cell cell) {
    return {cell.column / tileBlock, cell.row / tileBlock};
}

bool isParallel(const TileEdge& a, const TileEdge& b) {
    const int ax = a.end.x - a.start.x, ay = a.end.y - a.start.y;
    const int bx = b.end.x - b.start.x, by = b.end.y - b.start.y;
    return ax * by == ay * bx && ax * bx + ay * by > 0;
}

/// Do two consecutive edges belong to the same piece?
bool isOnePiece(const TileEdge& edge, const std::optional<TileEdge>& next) {
    return next && next->kind == edge.kind && isParallel(edge, *next) && blockOf(next->cell) == blockOf(edge.cell);
}

/// An edge on the map's other side belongs to another piece.
bool isWithin(const TileMap& map, const std::optional<TileEdge>& edge) {
    return edge && map.wrapped(edge->cell) == edge->cell;
}

std::optional<TileEdge> sameAfter(const TileMap& map, const TileEdge& edge) {
    const std::optional<TileEdge> next = edgeAfter(map, edge);
    if (!isWithin(map, next) || !isOnePiece(edge, next) || edgeBefore(map, *next) != edge) return std::nullopt;
    return next;
}

std::optional<TileEdge> sameBefore(const TileMap& map, const TileEdge& edge) {
    const std::optional<TileEdge> previous = edgeBefore(map, edge);
    if (!isWithin(map, previous) || !isOnePiece(*previous, edge) || edgeAfter(map, *previous) != edge)
        return std::nullopt;
    return previous;
}

class Scale {
public:
    explicit Scale(double size) : half_(0.5 * size) {}
    Vec2 operator()(HalfPoint p) const { return {p.x * half_, p.y * half_}; }
    /// From a to b, starting at c: where the map wraps, the neighbour may be on the other side.
    Vec2 operator()(HalfPoint c, HalfPoint a, HalfPoint b) const { return (*this)({c.x + b.x - a.x, c.y + b.y - a.y}); }

private:
    double half_;
};

/// Does the outline of a solid edge continue with this one? A collinear one-way top is not part of its outline: for a
/// body on top the line continues, for a body within the tile it has a corner there.
bool isOutline(const TileEdge& edge, const std::optional<TileEdge>& next) {
    return next && (edge.kind == TileKind::OneWay || next->kind != TileKind::OneWay);
}

/// Sets the neighbours at both ends of a segment. At a corner that is collinear with a one-way top, the neighbour turns
/// back along that top: a concave corner for a body within the tile, and no effect on a body that stands on top.
void setNeighbours(const TileMap& map, const TileEdge& first, const TileEdge& last, Segment& segment) {
    const Scale scale(map.size());
    const std::optional<TileEdge> before = edgeBefore(map, first), after = edgeAfter(map, last);
    if (isOutline(first, before)) segment.before = scale(first.start, before->end, before->start);
    if (isOutline(last, after)) segment.after = scale(last.end, after->start, after->end);
    if (const auto top = topOverStart(map, first)) segment.before = scale(first.start, top->start, top->end);
    if (const auto top = topOverEnd(map, last)) segment.after = scale(last.end, top->end, top->start);
}

/// The segment that begins with an edge.
TilePiece segmentFrom(const TileMap& map, const TileEdge& first) {
    const Scale scale(map.size());
    TileEdge last = first;
    while (const std::optional<TileEdge> next = sameAfter(map, last)) last = *next;
    Segment segment{scale(first.start), scale(last.end)};
    setNeighbours(map, first, last, segment);
    return {segment, first.kind, first.kind == TileKind::OneWay ? PieceUse::Both : PieceUse::Contact};
}

/// Columns and rows of a block that are within the map.
struct CellRange {
    Cell first, end;
};

CellRange cellsOf(const TileMap& map, Cell block) {
    const Cell first{block.column * tileBlock, block.row * tileBlock};
    return {first, {std::min(first.column + tileBlock, map.columns()), std::min(first.row + tileBlock, map.rows())}};
}

bool hasArea(const Tile& tile) {
    return !isEmpty(tile) && tile.kind != TileKind::OneWay;
}

/// The end of a run of full tiles of one kind, to the right of a cell: they are one rectangle.
int endOfRun(const TileMap& map, Cell cell, int end) {
    const Tile tile = map.at(cell);
    int column = cell.column + 1;
    if (tile.form != TileForm::Full) return column;
    const auto isSame = [&](const Tile& t) { return t.form == tile.form && t.kind == tile.kind; };
    while (column < end && isSame(map.at({column, cell.row}))) ++column;
    return column;
}

TilePiece areaOf(const TileMap& map, Cell cell, int end) {
    const TileKind kind = map.at(cell).kind;
    const PieceUse use = kind == TileKind::Sensor ? PieceUse::Both : PieceUse::Query;
    if (end - cell.column == 1) return {Polygon{map.cornersOf(cell)}, kind, use};
    const Vec2 lower = map.lowerLeft(cell), upper = map.lowerLeft({end, cell.row + 1});
    return {Polygon{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}}, kind, use};
}

}  // namespace

std::vector<TilePiece> tilePiecesOf(const TileMap& map, Cell block) {
    const CellRange cells = cellsOf(map, block);
    std::vector<TilePiece> pieces;
    for (int row = cells.first.row; row < cells.end.row; ++row)
        for (int column = cells.first.column; column < cells.end.column; ++column)
            for (const TileEdge& edge : openEdges(map, {column, row}))
                if (!sameBefore(map, edge)) pieces.push_back(segmentFrom(map, edge));
    for (int row = cells.first.row; row < cells.end.row; ++row) {
        for (int column = cells.first.column; column < cells.end.column;) {
            const Cell cell{column, row};
            const bool filled = hasArea(map.at(cell));
            const int end = filled ? endOfRun(map, cell, cells.end.column) : column + 1;
            if (filled) pieces.push_back(areaOf(map, cell, end));
            column = end;
        }
    }
    return pieces;
}

std::vector<TilePiece> tilePiecesOf(const TileMap& map) {
    const Cell blocks = tileBlocksOf(map);
    std::vector<TilePiece> pieces;
    for (int row = 0; row < blocks.row; ++row) {
        for (int column = 0; column < blocks.column; ++column) {
            std::vector<TilePiece> some = tilePiecesOf(map, {column, row});
            pieces.insert(pieces.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
        }
    }
    return pieces;
}

Cell tileBlocksOf(const TileMap& map) {
    return {(map.columns() + tileBlock - 1) / tileBlock, (map.rows() + tileBlock - 1) / tileBlock};
}

std::vector<Cell> tileBlocksAt(const TileMap& map, Cell cell) {
    std::vector<Cell> blocks;
    for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
        for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
            if (!map.contains({column, row})) continue;
            const Cell block = blockOf(map.wrapped({column, row}));
            if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) blocks.push_back(block);
        }
    }
    return blocks;
}

}  // namespace plumb
