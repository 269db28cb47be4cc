// SPDX-License-Identifier: MIT
// Of which pieces does a shape consist in the space? Of one, or of several for a chain or a tile map; a tile map
// changes some of them while bodies lie on it.
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// The pieces of one shape; none when the body has no shape of that number.
std::span<const ProxyId> piecesOf(const WorldState& world, BodyIndex body, std::uint32_t number);
/// Copies a definition without its shape, because a chain or a map may be large.
ShapeDef withoutShape(const ShapeDef& whole);
/// One of the pieces that a shape has in the space.
struct PieceDef {
    ShapeDef def;
    PieceUse use = PieceUse::Both;
};
/// severalPieces: the shape may have more pieces than these.
std::vector<ProxyId> addPieces(WorldState& world, BodyIndex body, std::uint32_t number, std::span<const PieceDef> parts,
                               bool severalPieces);
void removePieces(WorldState& world, BodyIndex body, std::span<const ProxyId> pieces);
/// Wakes the bodies that touch one piece.
void wakeTouchingPiece(WorldState& world, BodyIndex body, ProxyId piece);

/// Computes a body's radii from its shapes.
void measureAnew(WorldState& world, BodyIndex body);
/// Stores the outline of a piece with the contacts.
void outlinePiece(WorldState& world, ProxyId proxy, const Vec2& localCenter);
/// The number of pieces that are walls: solid pieces of a body that is enabled and not dynamic.
std::uint32_t wallsOf(const WorldState& world, std::span<const ProxyId> proxies, BodyIndex body);
/// The number of pieces that are segments of chains or of outlines.
std::uint32_t chainPiecesOf(const WorldState& world, std::span<const ProxyId> proxies);

/// Adds a shape whose def.shape is a tile map. Its first piece touches nothing, so that even an empty map has a piece.
void addTiles(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number);
/// Changes a tile of a shape that is a tile map. Replaces only the pieces that the tile was or is a part of, or that
/// end at it; bodies that touched these pieces wake.
void editTile(WorldState& world, BodyIndex body, std::uint32_t number, Cell cell, const Tile& tile);
/// The definition of one piece: that of the whole shape, with the piece's own shape and the properties of its tiles'
/// kind.
ShapeDef pieceOf(const ShapeDef& whole, const Proxy& piece);

}  // namespace plumb
