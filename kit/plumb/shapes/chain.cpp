// SPDX-License-Identifier: MIT
#include <plumb/shapes/chain.h>

#include <plumb/shapes/detail/point_sets.h>
#include <plumb/shapes/tile_pieces.h>

namespace plumb {

namespace {

std::vector<Shape> segmentsOf(const Chain& chain) {
    requireCount(chain);
    const std::vector<Vec2>& points = chain.points;
    const std::size_t count = points.size();
    const std::size_t segments = chain.closed ? count : count - 1;
    std::vector<Shape> pieces;
    pieces.reserve(segments);
    for (std::size_t i = 0; i < segments; ++i) {
        Segment segment{points[i], points[(i + 1) % count]};
        if (chain.closed || i > 0) segment.before = points[(i + count - 1) % count];
        if (chain.closed || i + 1 < segments) segment.after = points[(i + 2) % count];
        pieces.emplace_back(segment);
    }
    return pieces;
}

std::vector<Shape> filledBy(const TileMap& map) {
    std::vector<Shape> pieces;
    for (TilePiece& piece : tilePiecesOf(map))
        if (piece.use != PieceUse::Contact && piece.kind != TileKind::Sensor) pieces.push_back(std::move(piece.shape));
    return pieces;
}

}  // namespace

bool hasPieces(const Shape& shape) {
    return std::holds_alternative<Chain>(shape) || std::holds_alternative<TileMap>(shape);
}

std::vector<Shape> piecesOf(const Shape& shape) {
    if (const auto* chain = std::get_if<Chain>(&shape)) return segmentsOf(*chain);
    if (const auto* map = std::get_if<TileMap>(&shape)) return filledBy(*map);
    return {shape};
}

}  // namespace plumb
