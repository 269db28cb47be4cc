// SPDX-License-Identifier: MIT
#include <compare/metric/solid_shapes.h>

#include <utility>

#include <plumb/shapes/tile_pieces.h>

namespace plumb::compare {
namespace {

/// A map is long and what touches it is small: each part of what its solid tiles fill by itself.
std::vector<ShapeDef> solidParts(const ShapeDef& shape) {
    const auto* map = std::get_if<TileMap>(&shape.shape);
    if (map == nullptr) return {shape};
    std::vector<ShapeDef> parts;
    for (TilePiece& piece : tilePiecesOf(*map)) {
        if (piece.use != PieceUse::Query) continue;
        parts.push_back({.shape = std::move(piece.shape), .filter = shape.filter});
    }
    return parts;
}

}  // namespace

std::vector<SolidShape> solidShapes(const Scene& scene) {
    std::vector<SolidShape> shapes;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        for (const ShapeDef& shape : def.shapes)
            if (!shape.sensor && !shape.oneWay && def.enabled)
                for (ShapeDef& part : solidParts(shape))
                    shapes.push_back({i, std::move(part), def.type == BodyType::Dynamic});
    }
    return shapes;
}

}  // namespace plumb::compare
