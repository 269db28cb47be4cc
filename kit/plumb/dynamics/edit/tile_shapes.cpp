// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/tile_shapes.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/edit/shape_pieces.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/tile_pieces.h>

namespace plumb {

namespace {

/// Also without its density, because a map has no mass.
ShapeDef weightless(const ShapeDef& whole) {
    ShapeDef part = withoutShape(whole);
    part.material.density = 0;
    return part;
}

std::vector<PieceDef> partsOf(const ShapeDef& whole, std::vector<TilePiece> pieces) {
    const ShapeDef common = weightless(whole);
    std::vector<PieceDef> parts;
    parts.reserve(pieces.size());
    for (TilePiece& piece : pieces) {
        if (whole.sensor && piece.use == PieceUse::Contact) continue;
        parts.push_back({common, whole.sensor ? PieceUse::Both : piece.use});
        ShapeDef& part = parts.back().def;
        part.shape = std::move(piece.shape);
        part.sensor = whole.sensor || piece.kind == TileKind::Sensor;
        if (piece.kind == TileKind::OneWay) part.oneWay = Vec2(0, 1);
    }
    return parts;
}

/// A piece that touches nothing, so that a map has at least one piece even if it is empty.
PieceDef placeholderOf(const ShapeDef& whole, const TileMap& map) {
    PieceDef part{weightless(whole), PieceUse::None};
    part.def.shape = Segment{map.lowerLeft({0, 0}), map.lowerLeft({1, 1})};
    return part;
}

bool isSame(const WorldState& world, ProxyId proxy, const PieceDef& part) {
    const Proxy& there = world.space[proxy];
    return there.use == part.use && there.def.sensor == part.def.sensor && there.def.oneWay == part.def.oneWay &&
           there.def.shape == part.def.shape;
}

bool hasLength(const std::optional<double>& round, double length) {
    return round && std::fabs(*round - length) <= 1e-9 * length;
}

/// The map wraps if it lies unrotated in a world that wraps, and is as wide or as high as the world; otherwise it has
/// ends. The map's own wrap setting is ignored.
TileMap withWrapOfWorld(const TileMap& map, const WorldState& world, BodyIndex body) {
    const Rot& turned = world.bodies.motion[body].rotation;
    const bool straight = turned.cos == 1 && turned.sin == 0;
    const Wrap& wrap = world.bodies.wrap;
    return map.wrapping(straight && hasLength(wrap.width, map.columns() * map.size()),
                        straight && hasLength(wrap.height, map.rows() * map.size()));
}

void wakeOn(WorldState& world, BodyIndex body, const std::vector<ProxyId>& pieces) {
    for (const ProxyId piece : pieces) wakeTouchingPiece(world, body, piece);
}

/// Replaces a block's pieces. Pieces that do not change stay, with their contacts.
void renewBlock(WorldState& world, BodyIndex body, std::uint32_t number, Cell block) {
    TileShape& tiles = world.tiles.at({body, number});
    std::vector<ProxyId>& present = tiles.blocks[{block.row, block.column}];
    std::vector<PieceDef> parts = partsOf(tiles.def, tilePiecesOf(tiles.map(), block));
    std::vector<ProxyId> kept, gone;
    for (const ProxyId proxy : present) {
        const auto same =
            std::find_if(parts.begin(), parts.end(), [&](const PieceDef& part) { return isSame(world, proxy, part); });
        (same == parts.end() ? gone : kept).push_back(proxy);
        if (same != parts.end()) parts.erase(same);
    }
    wakeOn(world, body, gone);
    removePieces(world, body, gone);
    present = std::move(kept);
    const std::vector<ProxyId> added = addPieces(world, body, number, parts, true);
    present.insert(present.end(), added.begin(), added.end());
}

}  // namespace

void addTiles(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number) {
    TileShape& tiles = world.tiles[{body, number}];
    tiles = {def, {}};
    tiles.def.shape = withWrapOfWorld(std::get<TileMap>(def.shape), world, body);
    addPieces(world, body, number, std::vector{placeholderOf(def, tiles.map())}, true);
    const Cell blocks = tileBlocksOf(tiles.map());
    for (int row = 0; row < blocks.row; ++row)
        for (int column = 0; column < blocks.column; ++column)
            tiles.blocks[{row, column}] =
                addPieces(world, body, number, partsOf(tiles.def, tilePiecesOf(tiles.map(), {column, row})), true);
}

void editTile(WorldState& world, BodyIndex body, std::uint32_t number, Cell cell, const Tile& tile) {
    TileShape& tiles = world.tiles.at({body, number});
    TileMap& map = std::get<TileMap>(tiles.def.shape);
    if (map.contains(cell) && map.at(cell) == tile) return;
    map.set(cell, tile);
    for (const Cell block : tileBlocksAt(map, cell)) renewBlock(world, body, number, block);
}

ShapeDef pieceOf(const ShapeDef& whole, const Proxy& piece) {
    const bool isMap = std::holds_alternative<TileMap>(whole.shape);
    ShapeDef part = isMap ? weightless(whole) : withoutShape(whole);
    part.shape = piece.def.shape;
    if (isMap) part.sensor = piece.def.sensor;
    if (isMap) part.oneWay = piece.def.oneWay;
    return part;
}

}  // namespace plumb
