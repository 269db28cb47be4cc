// SPDX-License-Identifier: MIT
#include <games/artillery/pieces.h>

#include <algorithm>

namespace plumb::games::artillery {
namespace {

const std::array<PieceForm, 6> forms{{
    {{0.5, 0.5}, 2.0, 0},       // crate
    {{0.22, 1.0}, 4.2, 0},      // pillar, of stone
    {{2.1, 0.18}, 3.2, 0},      // plank
    {{1.5, 0.16}, 3.5, 0},      // lintel
    {{0.36, 0.46}, 4.0, 0.12},  // keg
    {{0.34, 0.12}, 1.0, 0.04},  // hat
}};

constexpr double plankY = 2.18, upperY = 3.36;

const std::array<Piece, 8> watchtowerPieces{{
    {PieceKind::Pillar, {-1.6, 1}},
    {PieceKind::Pillar, {1.6, 1}},
    {PieceKind::Crate, {0, 0.5}},
    {PieceKind::Plank, {0, plankY}},
    {PieceKind::Pillar, {-1.1, upperY}},
    {PieceKind::Pillar, {1.1, upperY}},
    {PieceKind::Keg, {0, plankY + 0.18 + 0.46}},
    {PieceKind::Lintel, {0, upperY + 1.16}},
}};
const std::array<Piece, 6> wallPieces{{
    {PieceKind::Crate, {-0.52, 0.5}},
    {PieceKind::Crate, {0.52, 0.5}},
    {PieceKind::Crate, {-0.52, 1.5}},
    {PieceKind::Crate, {0.52, 1.5}},
    {PieceKind::Crate, {0, 2.5}},
    {PieceKind::Crate, {0, 3.5}},
}};
const std::array<Piece, 10> pyramidPieces{{
    {PieceKind::Crate, {-1.56, 0.5}},
    {PieceKind::Crate, {-0.52, 0.5}},
    {PieceKind::Crate, {0.52, 0.5}},
    {PieceKind::Crate, {1.56, 0.5}},
    {PieceKind::Crate, {-1.04, 1.5}},
    {PieceKind::Crate, {0, 1.5}},
    {PieceKind::Crate, {1.04, 1.5}},
    {PieceKind::Crate, {-0.52, 2.5}},
    {PieceKind::Keg, {0.52, 2.46}},
    {PieceKind::Crate, {-0.52, 3.5}},
}};
const std::array<Piece, 5> powderStorePieces{{
    {PieceKind::Keg, {-0.4, 0.46}},
    {PieceKind::Keg, {0.4, 0.46}},
    {PieceKind::Crate, {-1.3, 0.5}},
    {PieceKind::Crate, {1.3, 0.5}},
    {PieceKind::Keg, {0, 1.38}},
}};
const std::array<Piece, 7> gatePieces{{
    {PieceKind::Pillar, {-1.1, 1}},
    {PieceKind::Pillar, {1.1, 1}},
    {PieceKind::Lintel, {0, 2.16}},
    {PieceKind::Pillar, {-1.1, 3.32}},
    {PieceKind::Pillar, {1.1, 3.32}},
    {PieceKind::Lintel, {0, 4.48}},
    {PieceKind::Crate, {0, 5.14}},
}};

}  // namespace

const Building watchtower{watchtowerPieces, 2.3, upperY + 1.32};
const Building wall{wallPieces, 1.2, 0};
const Building pyramid{pyramidPieces, 2.2, 0};
const Building powderStore{powderStorePieces, 1.95, 0};
const Building gate{gatePieces, 1.7, 0};

const PieceForm& formOf(PieceKind kind) {
    return forms[static_cast<std::size_t>(kind)];
}

BodyDef pieceDef(PieceKind kind, const Vec2& at) {
    const PieceForm& form = formOf(kind);
    const Vec2 core = form.halfSize - Vec2(form.rounding, form.rounding);
    ShapeDef box = roundedBox(core, form.rounding, {.density = form.density, .friction = 0.7});
    box.filter = {.category = Thing, .mask = Ground | Thing | Person | Shot | Sea | Blast};
    if (kind == PieceKind::Hat) box.filter.mask = Ground | Thing | Sea | Blast;
    return {.position = at, .angularDamping = 0.3, .shapes = {box}};
}

BodyDef gunnerDef(const Vec2& middle) {
    const double reach = gunnerHalf - gunnerRadius;
    ShapeDef body = capsule({0, -reach}, {0, reach}, gunnerRadius, {.density = 2, .friction = 1});
    body.filter = {.category = Person, .mask = Ground | Thing | Person | Shot | Sea | Blast};
    return {.position = middle, .fixedRotation = true, .shapes = {body}};
}

double distanceToGunner(const Vec2& middle, const Vec2& point) {
    const double reach = gunnerHalf - gunnerRadius;
    const Vec2 nearest(middle.x(), std::clamp(point.y(), middle.y() - reach, middle.y() + reach));
    return std::max(0.0, (point - nearest).norm() - gunnerRadius);
}

}  // namespace plumb::games::artillery
