// SPDX-License-Identifier: MIT
// Which pieces of a tile map collide one by one, so that together they make a shape without inner edges?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/shapes/shape.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// What a piece of a shape is there for.
enum class PieceUse : std::uint8_t {
    Both,   ///< bodies touch it, and queries find it
    Touch,  ///< bodies touch it: part of an outline
    Ask,    ///< queries find it: part of an area
    None,   ///< nothing meets it
};

/// Cells are pieced together by squares of so many columns and rows: an edit changes pieces of its square, and of those
/// beside it, only.
inline constexpr int tileBlock = 16;

/// A stretch of the outline, with its neighbours, or a convex part of the area. One-way tiles are outline only, sensors
/// area only.
struct TilePiece {
    Shape shape;
    TileKind kind = TileKind::Solid;
    PieceUse use = PieceUse::Both;
    friend bool operator==(const TilePiece&, const TilePiece&) = default;
};

/// Those of one block: columns from block.column * tileBlock on, rows likewise. Edges on which two tiles lie against
/// each other are gone. What is in line is one piece.
std::vector<TilePiece> tilePiecesOf(const TileMap& map, Cell block);
/// Of all blocks, row by row.
std::vector<TilePiece> tilePiecesOf(const TileMap& map);

/// How many columns and rows of blocks there are.
Cell tileBlocksOf(const TileMap& map);
/// The blocks whose pieces may change with a cell, each once.
std::vector<Cell> tileBlocksAt(const TileMap& map, Cell cell);

}  // namespace plumb
