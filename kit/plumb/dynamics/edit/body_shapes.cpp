// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/body_shapes.h>

#include <algorithm>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/shape_pieces.h>
#include <plumb/dynamics/sensors/sensors.h>
#include <plumb/math/vec2.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

void removeAllPairs(WorldState& world, BodyIndex body) {
    forEachContact(world.bodies, world.contacts, body, [&world](ContactIndex c) { removeContact(world, c); });
    for (const ProxyId proxy : world.bodies.links[body].proxies) removeSensorPairs(world.sensors, proxy);
}

/// Moves the centre of mass; the body's origin stays where it is, and so does each of its points with its velocity: so
/// the velocity of the centre changes, if the body turns. All that is stored from the centre of mass, outlines,
/// manifolds, anchors and radii, moves with it. Test: "a spinning body whose type, mass or shapes change stays where it
/// is and moves on as it did"
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
    for (const ProxyId proxy : world.bodies.links[body].proxies) {
        world.space.change(proxy, record.type == BodyType::Static, localCenter);
        outlinePiece(world, proxy, localCenter);
    }
    const Vec2f shiftF = shift.cast<float>();
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        renewContact(world, index);
        ContactRecord& contact = world.contacts[index];
        if (contact.bodyA == body)
            for (ManifoldPoint& point : contact.manifold.points) point.position -= shiftF;
    });
    measureAnew(world, body);
    shiftAnchors(world, body, shift);
}

}  // namespace

/// A chain is stored only as its segments, a map once beside its pieces: so a shape needs no second copy of its points.
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

/// Before a shape changes or goes, checks ask what would be left. Pieces of maps have no density (shape_pieces.cpp).
Mass massOfShapesWithout(const WorldState& world, BodyIndex body, std::uint32_t number) {
    std::vector<Mass> parts;
    for (const ProxyId proxy : world.bodies.links[body].proxies) {
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
    // The whole shape is not copied with each piece: a chain may have very many.
    const ShapeDef common = withoutShape(def);
    std::vector<PieceDef> parts;
    for (Shape& piece : piecesOf(def.shape)) {
        parts.push_back({common, PieceUse::Both});
        parts.back().def.shape = std::move(piece);
    }
    addPieces(world, body, number, parts, std::holds_alternative<Chain>(def.shape));
}

void wakeTouching(WorldState& world, BodyIndex body, std::uint32_t number) {
    std::vector<BodyIndex> others;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts[index];
        const bool first = contact.bodyA == body;
        if (contact.touching && (first ? world.space[contact.proxyA] : world.space[contact.proxyB]).number == number)
            others.push_back(first ? contact.bodyB : contact.bodyA);
    });
    for (const BodyIndex other : others) wakeIsland(world, other);
    wakeIsland(world, body);
}

/// Contacts that a new filter forbids go, the others get their new material. Pairs that it now allows are looked for at
/// once, because the broad phase reports only pairs whose bounds have come to overlap since its last search.
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
        outlinePiece(world, proxy, world.bodies.record[body].localCenter);
    }
    if (before.material == def.material && before.filter == def.filter) return;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        ContactRecord& contact = world.contacts[index];
        if (std::find(pieces.begin(), pieces.end(), contact.bodyA == body ? contact.proxyA : contact.proxyB) ==
            pieces.end())
            return;
        if (!mayPair(world.space[contact.proxyA], world.space[contact.proxyB])) {
            removeContact(world, index);
            return;
        }
        mixMaterials(world.space, contact);
        renewContact(world, index);
    });
    if (before.filter == def.filter || !world.bodies.record[body].enabled) return;
    for (const ProxyId proxy : pieces) {
        removeSensorPairs(world.sensors, proxy);
        addPairs(world, pairsOfShape(world.contacts, world.bodies, world.space, proxy));
    }
}

void removeShape(WorldState& world, BodyIndex body, std::uint32_t number) {
    const std::span<const ProxyId> pieces = piecesOf(world, body, number);
    removePieces(world, body, std::vector(pieces.begin(), pieces.end()));
    world.tiles.erase({body, number});
}

/// All of a body at once: removing them one by one would search the list of proxies for each.
void removeShapes(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    std::vector<ProxyId>& proxies = world.bodies.links[body].proxies;
    world.walls -= wallsOf(world, proxies, body);
    world.chainPieces -= chainPiecesOf(world, proxies);
    for (const ProxyId proxy : proxies) {
        forgetSensor(world.sensors, proxy);
        world.space.remove(proxy);
    }
    proxies.clear();
    world.tiles.erase(world.tiles.lower_bound({body, 0}), world.tiles.upper_bound({body, none}));
}

/// After a jump, or when shapes are shown again. The bounds are placed now and marked as new, so the next step finds
/// pairs at the new place, also with sleeping bodies; notePlaced lets overlap there be shifted apart
/// (loads/push_apart.h) in place of flinging the body.
void findPairsAgain(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    if (!world.bodies.record[body].enabled) return;
    placeBounds(world.space, world.bodies, world.contacts, body, 0);
    world.bodies.notePlaced(body);
    for (const ProxyId proxy : world.bodies.links[body].proxies) world.space.markNew(proxy);
}

void fixShapes(WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    for (const ProxyId proxy : world.bodies.links[body].proxies) {
        world.space.change(proxy, record.type == BodyType::Static, record.localCenter);
        world.space.setDriven(proxy, record.type == BodyType::Kinematic);
    }
}

/// wallsOf counts nothing for a body that is disabled, so walls are subtracted first; showShapes enables it first.
void hideShapes(WorldState& world, BodyIndex body) {
    removeAllPairs(world, body);
    const std::vector<ProxyId>& proxies = world.bodies.links[body].proxies;
    world.walls -= wallsOf(world, proxies, body);
    world.bodies.record[body].enabled = false;
    world.joints.noteEdits(world.bodies.links[body].joints);
    for (const ProxyId proxy : proxies) world.space.hide(proxy);
}

void showShapes(WorldState& world, BodyIndex body) {
    world.bodies.record[body].enabled = true;
    world.joints.noteEdits(world.bodies.links[body].joints);
    world.walls += wallsOf(world, world.bodies.links[body].proxies, body);
    findPairsAgain(world, body);
}

void giveMass(WorldState& world, BodyIndex body, const Mass& mass) {
    recenter(world, body, mass.center);
    setMass(world.bodies.record[body], mass);
    world.joints.noteEdits(world.bodies.links[body].joints);
    // The solver's data of a contact depend on the bodies' inertia.
    forEachContact(world.bodies, world.contacts, body, [&world](ContactIndex c) { renewContact(world, c); });
    // Its place in the solver's floats holds its inertia; an awake body is loaded anew in each step.
    if (!world.bodies.record[body].awake) world.bodies.rest(body);
}

/// Nothing happens if the mass stays: an edit of a tag must not renew contacts or wake the body.
void updateMassFromShapes(WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    if (record.type != BodyType::Dynamic || record.massGiven) return;
    const Mass mass = massOfShapes(world, body);
    if (mass.mass == record.mass && mass.inertia == record.inertia && mass.center == record.localCenter) return;
    giveMass(world, body, mass);
    wakeIsland(world, body);
}

}  // namespace plumb
