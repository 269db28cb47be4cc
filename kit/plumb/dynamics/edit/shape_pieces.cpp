// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/shape_pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/sensors/sensors.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/tile_pieces.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// Of the outline in floats, from the centre of mass: that is what the narrow phase sees.
double boundingRadiusOf(const Convex& convex) {
    float farthest = 0;
    for (int i = 0; i < convex.count; ++i)
        farthest = std::max(farthest, convex.vertices[static_cast<std::size_t>(i)].norm());
    return static_cast<double>(farthest + convex.radius);
}

/// Updates a body's radii with added pieces: the outer ones are those of the farthest piece, the inradius is that of
/// the thinnest, which is the first to pass through a wall. Sensors do not count, because they do not touch anything.
void measure(const WorldState& world, std::span<const ProxyId> added, BodyRecord& record) {
    for (const ProxyId id : added) {
        const Proxy& proxy = world.space[id];
        if (proxy.def.sensor || proxy.use == PieceUse::None) continue;
        record.boundingRadius = std::max(record.boundingRadius, boundingRadiusOf(proxy.convex));
        record.turningRadius = std::max(record.turningRadius, turningRadiusOf(proxy.def.shape, record.localCenter));
        record.inradius = std::min(record.inradius, inradiusOf(proxy.def.shape));
    }
}

/// Adds a piece of a shape to the space, at the body's present position.
ProxyId addPiece(WorldState& world, BodyIndex body, const PieceDef& part, std::uint32_t number, bool severalPieces) {
    const BodyRecord& record = world.bodies.record[body];
    const Aabb box = aabbOf(part.def.shape, world.bodies.pose(body));
    const bool fixed = record.type == BodyType::Static;
    const ProxyId proxy =
        world.space.add(part.def, body, fixed, record.localCenter, box, number, severalPieces, part.use);
    world.space.setDriven(proxy, record.type == BodyType::Kinematic);
    if (part.def.sensor) addSensor(world.sensors, proxy);
    if (!record.enabled) world.space.hide(proxy);
    world.bodies.notePlaced(body);
    outlinePiece(world, proxy, record.localCenter);
    return proxy;
}

/// O(contacts of the body) for each piece: a map under a crowd has many.
void removePairs(WorldState& world, BodyIndex body, ProxyId proxy) {
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts[index];
        if (contact.proxyA == proxy || contact.proxyB == proxy) removeContact(world, index);
    });
    removeSensorPairs(world.sensors, proxy);
}

/// Reads nothing but the list, in one pass, and asks first whether a number is in the range of those that go: a map may
/// have millions of pieces, and a block only some that lie near each other in it.
void eraseFrom(std::vector<ProxyId>& proxies, std::span<const ProxyId> gone) {
    const auto [least, most] = std::minmax_element(gone.begin(), gone.end());
    std::erase_if(proxies, [gone, first = *least, last = *most](ProxyId proxy) {
        return proxy >= first && proxy <= last && std::find(gone.begin(), gone.end(), proxy) != gone.end();
    });
}

}  // namespace

ShapeDef withoutShape(const ShapeDef& whole) {
    ShapeDef part;
    part.material = whole.material;
    part.filter = whole.filter;
    part.sensor = whole.sensor;
    part.oneWay = whole.oneWay;
    part.rule = whole.rule;
    part.tag = whole.tag;
    return part;
}

/// Proxies are in the order of their shapes' numbers: O(log n). The upper end is compared in 64 bits, because the
/// largest number plus one does not fit into 32.
std::span<const ProxyId> piecesOf(const WorldState& world, BodyIndex body, std::uint32_t number) {
    const std::vector<ProxyId>& proxies = world.bodies.links[body].proxies;
    const auto isBelow = [&world](ProxyId proxy, std::uint32_t n) { return world.space[proxy].number < n; };
    const auto first = std::lower_bound(proxies.begin(), proxies.end(), number, isBelow);
    const auto last = std::lower_bound(first, proxies.end(), number + std::uint64_t{1},
                                       [&world](ProxyId p, std::uint64_t n) { return world.space[p].number < n; });
    return {first, last};
}

void measureAnew(WorldState& world, BodyIndex body) {
    BodyRecord& record = world.bodies.record[body];
    record.boundingRadius = record.turningRadius = 0;
    record.inradius = std::numeric_limits<double>::infinity();
    measure(world, world.bodies.links[body].proxies, record);
}

/// WorldState::walls counts these, so that a world without walls skips all searches for them.
std::uint32_t wallsOf(const WorldState& world, std::span<const ProxyId> proxies, BodyIndex body) {
    const BodyRecord& owner = world.bodies.record[body];
    if (owner.type == BodyType::Dynamic || !owner.enabled) return 0;
    const auto solid = [&world](ProxyId proxy) {
        return !world.space[proxy].def.sensor && world.space.filterKey(proxy).collides;
    };
    return static_cast<std::uint32_t>(std::count_if(proxies.begin(), proxies.end(), solid));
}

/// WorldState::chainPieces counts these, so that only worlds with chains look for discs that slide.
std::uint32_t chainPiecesOf(const WorldState& world, std::span<const ProxyId> proxies) {
    const auto isOfChain = [&world](ProxyId proxy) {
        return world.space[proxy].piece && std::holds_alternative<Segment>(world.space[proxy].def.shape);
    };
    return static_cast<std::uint32_t>(std::count_if(proxies.begin(), proxies.end(), isOfChain));
}

void outlinePiece(WorldState& world, ProxyId proxy, const Vec2& localCenter) {
    const Convex& convex = world.space[proxy].convex;
    BoxOutline outline = boxOutlineOf(world.space[proxy].def, localCenter);
    // A segment of an outline is one-sided, so it is not a plain line, even where it continues into one-way tops at
    // both ends.
    if (convex.oneSided) outline.kind = BoxOutline::Kind::Other;
    setOutline(world.contacts, proxy, outline, convex);
}

/// Inserts them behind the pieces of the same shape: the list stays in the order of numbers, on which piecesOf relies.
std::vector<ProxyId> addPieces(WorldState& world, BodyIndex body, std::uint32_t number, std::span<const PieceDef> parts,
                               bool severalPieces) {
    std::vector<ProxyId>& proxies = world.bodies.links[body].proxies;
    std::vector<ProxyId> added;
    for (const PieceDef& part : parts) added.push_back(addPiece(world, body, part, number, severalPieces));
    const auto isAbove = [&world](std::uint32_t n, ProxyId proxy) { return n < world.space[proxy].number; };
    const auto at = std::upper_bound(proxies.begin(), proxies.end(), number, isAbove);
    proxies.insert(at, added.begin(), added.end());
    world.walls += wallsOf(world, added, body);
    world.chainPieces += chainPiecesOf(world, added);
    measure(world, added, world.bodies.record[body]);
    return added;
}

void removePieces(WorldState& world, BodyIndex body, std::span<const ProxyId> pieces) {
    if (pieces.empty()) return;
    world.walls -= wallsOf(world, pieces, body);
    world.chainPieces -= chainPiecesOf(world, pieces);
    for (const ProxyId proxy : pieces) {
        removePairs(world, body, proxy);
        forgetSensor(world.sensors, proxy);
        world.space.remove(proxy);
    }
    eraseFrom(world.bodies.links[body].proxies, pieces);
    // The radii of a body that is not pushed are bounds; a map may have millions of pieces, and loses them one by one.
    if (world.bodies.isDynamic(body) || world.bodies.links[body].proxies.empty()) measureAnew(world, body);
}

/// Only of this piece: bodies on the rest of a map sleep on. Test: "a body falls when the tile under it goes, and one
/// that sleeps far along the floor sleeps on"
void wakeTouchingPiece(WorldState& world, BodyIndex body, ProxyId piece) {
    std::vector<BodyIndex> others;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts[index];
        if (!contact.touching || (contact.proxyA != piece && contact.proxyB != piece)) return;
        others.push_back(otherOf(contact, body));
    });
    for (const BodyIndex other : others) wakeIsland(world, other);
}

namespace {

/// Also without its density, because a map has no mass.
ShapeDef weightless(const ShapeDef& whole) {
    ShapeDef part = withoutShape(whole);
    part.material.density = 0;
    return part;
}

/// The pieces of tiles with the properties of their kind: outlines for contacts, areas for queries. A sensor needs no
/// outline, because nothing touches it.
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

/// By value, because new pieces are cut without regard to the old ones.
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

/// Replaces a block's pieces. Pieces that do not change stay, with their contacts, and what rests on them feels
/// nothing. O(old pieces x new pieces) of the block.
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

/// Block by block, so that an edit replaces the pieces of one block, however large the map is.
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

/// Pieces may end at a tile of the next block, so the blocks beside an edge are renewed, too. Test: "a map edited 200
/// times is the map made so from the start, for rays, points and what falls on it"
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
