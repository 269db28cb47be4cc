// SPDX-License-Identifier: MIT
// Of which pieces is a shape made in the space? One, or, of a chain or a tile map, several.
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// The pieces of one shape; none when the body has no shape of that number.
std::span<const ProxyId> piecesOf(const WorldState& world, BodyIndex body, std::uint32_t number);
/// One of the pieces that a shape has in the space.
struct PieceDef {
    ShapeDef def;
    PieceUse use = PieceUse::Both;
};
/// severalPieces: there may be more of the same shape.
std::vector<ProxyId> addPieces(WorldState& world, BodyIndex body, std::uint32_t number, std::span<const PieceDef> parts,
                               bool severalPieces);
void removePieces(WorldState& world, BodyIndex body, std::span<const ProxyId> pieces);
/// Wakes what touches one piece.
void wakeTouchingPiece(WorldState& world, BodyIndex body, ProxyId piece);

/// Works out a body's radii from its shapes.
void measureAnew(WorldState& world, BodyIndex body);
/// Tells the contacts what outline a piece has.
void outlinePiece(WorldState& world, ProxyId proxy, const Vec2& localCenter);
/// How many of a body's pieces something may have to be stopped at.
std::uint32_t wallsOf(const WorldState& world, std::span<const ProxyId> proxies, BodyIndex body);

}  // namespace plumb
