// SPDX-License-Identifier: MIT
// What stands on an island, and of what is it built?
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
    double density = 1;   ///< [kg/m^2]; what has less than seaDensity floats
    double rounding = 0;  ///< of the corners, within halfSize [m]
};
const PieceForm& formOf(PieceKind kind);

/// A piece of a building, from the middle of its floor.
struct Piece {
    PieceKind kind = PieceKind::Crate;
    Vec2 at{0, 0};  ///< of its middle [m]
};
struct Building {
    std::span<const Piece> pieces;
    double halfWidth = 1;  ///< of the level ground it wants [m]
    double top = 0;        ///< where a gunner can stand on it, above the ground [m]; 0: nowhere
};

extern const Building watchtower, wall, pyramid, powderStore, gate;

/// A piece on its own, standing still.
BodyDef pieceDef(PieceKind kind, const Vec2& at);

inline constexpr double gunnerHalf = 0.9;     ///< half a gunner's height [m]
inline constexpr double gunnerRadius = 0.45;  ///< half the width [m]
BodyDef gunnerDef(const Vec2& middle);
/// From a point to the gunner's outline; 0 inside [m].
double distanceToGunner(const Vec2& middle, const Vec2& point);

}  // namespace plumb::games::artillery
