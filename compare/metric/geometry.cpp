// SPDX-License-Identifier: MIT
#include <compare/metric/geometry.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/observation.h>
#include <plumb/collide/distance.h>
#include <plumb/shapes/tile_pieces.h>

namespace plumb::compare {
namespace {

Transform poseOf(const BodyState& state) {
    return {state.position, Rot::fromAngle(state.angle)};
}

bool accepts(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// From all sides: what passes a one-way shape overlaps it rightly.
bool isSolid(const ShapeDef& shape) {
    return !shape.sensor && !shape.oneWay;
}

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

Geometry::Geometry(const Scene& scene) : wrap_(scene.wrap), joints_(scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        for (const ShapeDef& shape : def.shapes)
            if (isSolid(shape) && def.enabled)
                for (ShapeDef& part : solidParts(shape))
                    shapes_.push_back({i, std::move(part), def.type == BodyType::Dynamic});
    }
    for (const JointGeometry& joint : joints_.joints())
        if (!joint.collideConnected && joint.bodyA != noBody) keptApart_.insert(std::minmax(joint.bodyA, joint.bodyB));
    for (std::size_t i = 0; i < shapes_.size() && !anyMayTouch_; ++i)
        for (std::size_t j = 0; j < i && !anyMayTouch_; ++j) anyMayTouch_ = mayTouch(shapes_[i], shapes_[j]);
}

bool Geometry::mayTouch(const Placed& a, const Placed& b) const {
    return a.body != b.body && (a.dynamic || b.dynamic) && accepts(a.shape.filter, b.shape.filter) &&
           !keptApart_.contains(std::minmax(a.body, b.body));
}

std::optional<double> Geometry::penetration(std::span<const BodyState> states) const {
    if (!std::all_of(states.begin(), states.end(), isFinite)) return {};
    std::vector<Transform> poses;
    for (const BodyState& state : states) poses.push_back(poseOf(state));
    std::vector<const Placed*> present;
    std::vector<Aabb> boxes;
    for (const Placed& placed : shapes_) {
        if (!states[placed.body].present) continue;
        present.push_back(&placed);
        boxes.push_back(aabbOf(placed.shape.shape, poses[placed.body]));
    }
    Bvh tree;
    tree.build(boxes);
    double deepest = 0;
    const auto look = [&](const Pair& pair, const Vec2& shift) {
        const Placed& a = *present[pair.a];
        const Placed& b = *present[pair.b];
        if (!mayTouch(a, b)) return;
        const Transform there{poses[b.body].position + shift, poses[b.body].rotation};
        deepest = std::max(deepest, -distance(a.shape.shape, poses[a.body], b.shape.shape, there).separation);
    };
    for (const Pair& pair : tree.pairs()) look(pair, {0, 0});
    if (wrap_.any()) forEachAround(boxes, look);
    return deepest;
}

/// Whose boxes overlap once one of the two is shifted by a round. Such scenes are small.
template <class Look>
void Geometry::forEachAround(const std::vector<Aabb>& boxes, Look&& look) const {
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        for (std::uint32_t a = 0; a < boxes.size(); ++a) {
            for (const Vec2& rounds : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, -1)}) {
                const Vec2 shift = wrap_.imageOffset(rounds);
                const Aabb there{boxes[b].lower + shift, boxes[b].upper + shift};
                if (a != b && !shift.isZero(0) && overlap(boxes[a], there)) look({a, b}, shift);
            }
        }
    }
}

std::optional<double> Geometry::jointError(std::span<const BodyState> states, const Broken& broken) const {
    double worst = 0;
    for (std::size_t joint = 0; joint < joints_.joints().size(); ++joint) {
        if (joint < broken.size() && broken[joint]) continue;
        if (!joints_.isPresent(joint, states)) continue;
        if (!joints_.isKnown(joint, states)) return {};
        worst = std::max(worst, joints_.gap(joint, states));
    }
    return worst;
}

}  // namespace plumb::compare
