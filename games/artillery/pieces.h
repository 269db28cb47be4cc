// SPDX-License-Identifier: MIT
// What stands on an island, and what is it made of?
#pragma once
#include <array>
#include <span>

#include <games/artillery/rules.h>
#include <plumb/dynamics/body_def.h>

namespace plumb::games::artillery {

enum class PieceKind { Crate, Pillar, Plank, Lintel, Keg, Hat };

/// All are boxes.
struct PieceForm {
    Vec2 halfSize;        ///< [m]
    double density = 1;   ///< [kg/m^2]; pieces below seaDensity float
    double rounding = 0;  ///< of the corners, within halfSize [m]
};
const PieceForm& formOf(PieceKind kind);

/// A piece of a building, relative to the middle of the building's floor.
struct Piece {
    PieceKind kind = PieceKind::Crate;
    Vec2 at{0, 0};  ///< centre of the piece [m]
};
struct Building {
    std::span<const Piece> pieces;
    double halfWidth = 1;  ///< of the level ground that it needs [m]
    double top = 0;        ///< height above the ground where a gunner can stand [m]; 0: nowhere
};

extern const Building watchtower, wall, pyramid, powderStore, gate;

/// A single piece at rest.
BodyDef pieceDef(PieceKind kind, const Vec2& at);

inline constexpr double gunnerHalf = 0.9;     ///< half a gunner's height [m]
inline constexpr double gunnerRadius = 0.45;  ///< half the width [m]
BodyDef gunnerDef(const Vec2& middle);
/// Distance from a point to the gunner's outline; 0 inside [m].
double distanceToGunner(const Vec2& middle, const Vec2& point);

}  // namespace plumb::games::artillery
