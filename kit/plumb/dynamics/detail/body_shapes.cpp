// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/body_shapes.h>

#include <algorithm>
#include <limits>

#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/sensors.h>
#include <plumb/dynamics/detail/shape_measure.h>
#include <plumb/math/vec2f.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

double extentOf(const Convex& convex) {
    float farthest = 0;
    for (int i = 0; i < convex.count; ++i)
        farthest = std::max(farthest, convex.vertices[static_cast<std::size_t>(i)].norm());
    return static_cast<double>(farthest + convex.radius);
}

/// Sensors are nowhere in the body's way, and so do not count.
void measure(const WorldState& world, std::span<const ProxyId> added, BodyRecord& record) {
    for (const ProxyId id : added) {
        const Proxy& proxy = world.space[id];
        if (proxy.def.sensor || proxy.use == PieceUse::None) continue;
        record.extent = std::max(record.extent, extentOf(proxy.convex));
        record.reach = std::max(record.reach, reachOf(proxy.def.shape, record.localCenter));
        record.core = std::min(record.core, coreOf(proxy.def.shape));
    }
}

void measureAnew(WorldState& world, BodyIndex body) {
    BodyRecord& record = world.bodies.record[body];
    record.extent = record.reach = 0;
    record.core = std::numeric_limits<double>::infinity();
    measure(world, record.proxies, record);
}

/// How many of its shapes something may have to be stopped at.
std::uint32_t wallsOf(const WorldState& world, std::span<const ProxyId> proxies, const BodyRecord& owner) {
    if (owner.type == BodyType::Dynamic || !owner.enabled) return 0;
    const auto solid = [&world](ProxyId proxy) {
        return !world.space[proxy].def.sensor && world.space.gate(proxy).touched;
    };
    return static_cast<std::uint32_t>(std::count_if(proxies.begin(), proxies.end(), solid));
}

void outline(WorldState& world, ProxyId proxy, const Vec2& localCenter) {
    std::vector<BoxOutline>& boxes = world.contacts.boxes;
    if (boxes.size() <= proxy) boxes.resize(proxy + std::size_t{1});
    boxes[proxy] = boxOutlineOf(world.space[proxy].def, localCenter);
    // A stretch of an outline is more than a line, even where it goes on into one-way tops at both ends.
    if (world.space[proxy].convex.oneSided) boxes[proxy].kind = BoxOutline::Kind::Other;
}

/// A part of a shape comes into the space, where its body is now.
ProxyId addPiece(WorldState& world, BodyIndex body, const PieceDef& part, std::uint32_t number, bool severalPieces) {
    const BodyRecord& record = world.bodies.record[body];
    const Aabb box = aabbOf(part.def.shape, world.bodies.pose(body));
    const bool fixed = record.type == BodyType::Static;
    const ProxyId proxy =
        world.space.add(part.def, body, fixed, record.localCenter, box, number, severalPieces, part.use);
    if (!record.enabled) world.space.hide(proxy);
    outline(world, proxy, record.localCenter);
    return proxy;
}

void removePairs(WorldState& world, BodyIndex body, ProxyId proxy) {
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        if (contact.proxyA == proxy || contact.proxyB == proxy) removeContact(world, index);
    });
    removeSensorPairs(world, proxy);
}

void removeAllPairs(WorldState& world, BodyIndex body) {
    forEachContact(world.bodies, world.contacts, body, [&world](ContactIndex c) { removeContact(world, c); });
    for (const ProxyId proxy : world.bodies.record[body].proxies) removeSensorPairs(world, proxy);
}

/// The body stays where it is; its centre of mass does not.
void recenter(WorldState& world, BodyIndex body, const Vec2& localCenter) {
    BodyRecord& record = world.bodies.record[body];
    const Vec2 shift = localCenter - record.localCenter;
    if (shift.isZero(0)) return;
    BodyMotion& motion = world.bodies.motion[body];
    const Vec2 moved = motion.rotation * shift;
    motion.center += moved;
    motion.velocity += perp(moved) * motion.angularVelocity;
    record.localCenter = localCenter;
    world.bodies.recenterPlace(body, shift);
    for (const ProxyId proxy : record.proxies) {
        world.space.change(proxy, record.type == BodyType::Static, localCenter);
        outline(world, proxy, localCenter);
    }
    const Vec2f shiftF = shift.cast<float>();
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        settleAnew(world, index);
        ContactRecord& contact = world.contacts.contacts[index];
        if (contact.bodyA == body)
            for (ManifoldPoint& point : contact.manifold.points) point.position -= shiftF;
    });
    measureAnew(world, body);
    if (world.jointSystem != nullptr) world.jointSystem->shiftAnchors(world, body, shift);
}

}  // namespace

std::span<const ProxyId> piecesOf(const WorldState& world, BodyIndex body, std::uint32_t number) {
    const std::vector<ProxyId>& proxies = world.bodies.record[body].proxies;
    const auto isBelow = [&world](ProxyId proxy, std::uint32_t n) { return world.space[proxy].number < n; };
    const auto first = std::lower_bound(proxies.begin(), proxies.end(), number, isBelow);
    const auto last = std::lower_bound(first, proxies.end(), number + std::uint64_t{1},
                                       [&world](ProxyId p, std::uint64_t n) { return world.space[p].number < n; });
    return {first, last};
}

ShapeDef shapeOf(const WorldState& world, std::span<const ProxyId> pieces) {
    ShapeDef def = world.space[pieces.front()].def;
    if (!world.space[pieces.front()].piece) return def;
    const Proxy& first = world.space[pieces.front()];
    if (const auto tiles = world.tiles.find({first.owner, first.number}); tiles != world.tiles.end())
        return tiles->second.def;
    Chain chain;
    chain.closed = std::get<Segment>(def.shape).before.has_value();
    for (const ProxyId piece : pieces) chain.points.push_back(std::get<Segment>(world.space[piece].def.shape).start);
    if (!chain.closed) chain.points.push_back(std::get<Segment>(world.space[pieces.back()].def.shape).end);
    def.shape = std::move(chain);
    return def;
}

Mass massOfShapesWithout(const WorldState& world, BodyIndex body, std::uint32_t number) {
    std::vector<Mass> parts;
    for (const ProxyId proxy : world.bodies.record[body].proxies) {
        const Proxy& shape = world.space[proxy];
        if (shape.number != number) parts.push_back(massOf(shape.def.shape, shape.def.material.density));
    }
    return combine(parts);
}

Mass massOfShapes(const WorldState& world, BodyIndex body) {
    return massOfShapesWithout(world, body, none);
}

void addShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number) {
    if (std::holds_alternative<TileMap>(def.shape)) {
        addTiles(world, body, def, number);
        return;
    }
    std::vector<PieceDef> parts;
    for (Shape& piece : piecesOf(def.shape)) {
        parts.push_back({def, PieceUse::Both});
        parts.back().def.shape = std::move(piece);
    }
    addPieces(world, body, number, parts, std::holds_alternative<Chain>(def.shape));
}

std::vector<ProxyId> addPieces(WorldState& world, BodyIndex body, std::uint32_t number, std::span<const PieceDef> parts,
                               bool severalPieces) {
    BodyRecord& record = world.bodies.record[body];
    std::vector<ProxyId> added;
    for (const PieceDef& part : parts) added.push_back(addPiece(world, body, part, number, severalPieces));
    const auto isAbove = [&world](std::uint32_t n, ProxyId proxy) { return n < world.space[proxy].number; };
    const auto at = std::upper_bound(record.proxies.begin(), record.proxies.end(), number, isAbove);
    record.proxies.insert(at, added.begin(), added.end());
    world.walls += wallsOf(world, added, record);
    measure(world, added, record);
    return added;
}

void removePieces(WorldState& world, BodyIndex body, std::span<const ProxyId> pieces) {
    if (pieces.empty()) return;
    BodyRecord& record = world.bodies.record[body];
    world.walls -= wallsOf(world, pieces, record);
    for (const ProxyId proxy : pieces) {
        removePairs(world, body, proxy);
        world.space.remove(proxy);
    }
    std::erase_if(record.proxies, [&world](ProxyId proxy) { return !world.space[proxy].alive; });
    measureAnew(world, body);
}

void wakeTouching(WorldState& world, BodyIndex body, std::uint32_t number) {
    std::vector<BodyIndex> others;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const bool first = contact.bodyA == body;
        if (contact.touching && (first ? world.proxyA(contact) : world.proxyB(contact)).number == number)
            others.push_back(first ? contact.bodyB : contact.bodyA);
    });
    for (const BodyIndex other : others) wakeIsland(world, other);
    wakeIsland(world, body);
}

void wakeTouchingPiece(WorldState& world, BodyIndex body, ProxyId piece) {
    std::vector<BodyIndex> others;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        if (!contact.touching || (contact.proxyA != piece && contact.proxyB != piece)) return;
        others.push_back(contact.bodyA == body ? contact.bodyB : contact.bodyA);
    });
    for (const BodyIndex other : others) wakeIsland(world, other);
}

void alterShape(WorldState& world, BodyIndex body, const ShapeDef& def, std::uint32_t number) {
    const std::span<const ProxyId> pieces = piecesOf(world, body, number);
    const ShapeDef before = world.space[pieces.front()].def;
    if (const auto tiles = world.tiles.find({body, number}); tiles != world.tiles.end()) {
        TileMap map = tiles->second.map();
        tiles->second.def = def;
        tiles->second.def.shape = std::move(map);
    }
    for (const ProxyId proxy : pieces) {
        world.space.change(proxy, pieceOf(def, world.space[proxy]));
        outline(world, proxy, world.bodies.record[body].localCenter);
    }
    if (before.material == def.material && before.filter == def.filter) return;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        ContactRecord& contact = world.contacts.contacts[index];
        if (std::find(pieces.begin(), pieces.end(), contact.bodyA == body ? contact.proxyA : contact.proxyB) ==
            pieces.end())
            return;
        if (!mayPair(world.proxyA(contact), world.proxyB(contact))) {
            removeContact(world, index);
            return;
        }
        mixMaterials(world, contact);
        settleAnew(world, index);
    });
    if (before.filter == def.filter || !world.bodies.record[body].enabled) return;
    for (const ProxyId proxy : pieces) {
        removeSensorPairs(world, proxy);
        pairShape(world, proxy);
    }
}

void removeShape(WorldState& world, BodyIndex body, std::uint32_t number) {
    const std::span<const ProxyId> pieces = piecesOf(world, body, number);
    removePieces(world, body, std::vector(pieces.begin(), pieces.end()));
    world.tiles.erase({body, number});
}

void removeShapes(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    BodyRecord& record = world.bodies.record[body];
    world.walls -= wallsOf(world, record.proxies, record);
    for (const ProxyId proxy : record.proxies) world.space.remove(proxy);
    record.proxies.clear();
    world.tiles.erase(world.tiles.lower_bound({body, 0}), world.tiles.upper_bound({body, none}));
}

void meetAnew(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    if (!world.bodies.record[body].enabled) return;
    placeBody(world, body, 0);
    for (const ProxyId proxy : world.bodies.record[body].proxies) world.space.renew(proxy);
}

void fixShapes(WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    for (const ProxyId proxy : record.proxies)
        world.space.change(proxy, record.type == BodyType::Static, record.localCenter);
}

void hideShapes(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    BodyRecord& record = world.bodies.record[body];
    world.walls -= wallsOf(world, record.proxies, record);
    record.enabled = false;
    for (const ProxyId proxy : record.proxies) world.space.hide(proxy);
}

void showShapes(WorldState& world, BodyIndex body) {
    BodyRecord& record = world.bodies.record[body];
    record.enabled = true;
    world.walls += wallsOf(world, record.proxies, record);
    meetAnew(world, body);
}

void settleAnew(WorldState& world, ContactIndex index) {
    const ContactRecord& contact = world.contacts.contacts[index];
    if (contact.colour < 0 && contact.nearIndex == none) return;  // asleep: it is going to be
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.removeNear(index);
    world.contacts.addNear(index);
}

void giveMass(WorldState& world, BodyIndex body, const Mass& mass) {
    recenter(world, body, mass.center);
    setMass(world.bodies.record[body], mass);
    // What the solver has of a contact is made for the bodies' inertia.
    forEachContact(world.bodies, world.contacts, body, [&world](ContactIndex c) { settleAnew(world, c); });
    if (!world.bodies.record[body].awake) world.bodies.rest(body);
}

void followShapes(WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    if (record.type != BodyType::Dynamic || record.massGiven) return;
    const Mass mass = massOfShapes(world, body);
    if (mass.mass == record.mass && mass.inertia == record.inertia && mass.center == record.localCenter) return;
    giveMass(world, body, mass);
    wakeIsland(world, body);
}

}  // namespace plumb
