// SPDX-License-Identifier: MIT
// Into which pieces is a tile map split, so that together they have no inner edges?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/shapes/shape.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// What a piece of a shape is used for.
enum class PieceUse : std::uint8_t {
    Both,     ///< contacts and queries
    Contact,  ///< contacts only: part of an outline
    Query,    ///< queries only: part of an area
    None,     ///< nothing
};

/// The pieces are built in square blocks of so many columns and rows: an edit changes the pieces of its own block, and
/// of the blocks beside it, only.
inline constexpr int tileBlock = 16;

/// A segment of the outline, with its neighbours, or a convex part of the area. One-way tiles have an outline only,
/// sensors an area only.
struct TilePiece {
    Shape shape;
    TileKind kind = TileKind::Solid;
    PieceUse use = PieceUse::Both;
    friend bool operator==(const TilePiece&, const TilePiece&) = default;
};

/// The pieces of one block: columns from block.column * tileBlock on, rows likewise. Edges between two adjacent tiles
/// are removed. Collinear edges are one piece.
std::vector<TilePiece> tilePiecesOf(const TileMap& map, Cell block);
/// The pieces of all blocks, row by row.
std::vector<TilePiece> tilePiecesOf(const TileMap& map);

/// The number of columns and rows of blocks.
Cell tileBlocksOf(const TileMap& map);
/// The blocks whose pieces may change with a cell, each once.
std::vector<Cell> tileBlocksAt(const TileMap& map, Cell cell);

}  // namespace plumb
