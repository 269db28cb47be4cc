// SPDX-License-Identifier: MIT
#include <compare/parting/touching.h>

#include <algorithm>
#include <limits>

#include <compare/metric/observation.h>
#include <compare/scene/joint_geometry.h>
#include <plumb/broad/bvh.h>
#include <plumb/collide/distance.h>
#include <plumb/collide/ray_cast.h>

namespace plumb::compare {
namespace {

constexpr double apartForGood = std::numeric_limits<double>::infinity();

Transform poseIn(const BodyState& state) {
    return {state.position, Rot::fromAngle(state.angle)};
}

bool isHere(const BodyState& state) {
    return state.present && isFinite(state);
}

}  // namespace

Touching::Touching(const Scene& scene) : wrap_(scene.wrap), ofBody_(scene.bodies.size()) {
    for (SolidShape& solid : solidShapes(scene)) {
        const Aabb box = aabbOf(solid.shape.shape, Transform{});
        ofBody_[solid.body].push_back(shapes_.size());
        shapes_.push_back({std::move(solid), (box.lower + box.upper) / 2, (box.upper - box.lower).norm() / 2});
    }
    for (const JointGeometry& joint : jointGeometries(scene))
        if (!joint.collideConnected && joint.bodyA != noBody) keptApart_.insert(std::minmax(joint.bodyA, joint.bodyB));
}

bool Touching::mayTouch(const Reach& a, const Reach& b) const {
    return a.solid.body != b.solid.body && (a.solid.dynamic || b.solid.dynamic) &&
           accepts(a.solid.shape.filter, b.solid.shape.filter) &&
           !keptApart_.contains(std::minmax(a.solid.body, b.solid.body));
}

std::optional<Touch> Touching::nearest(std::size_t body, std::span<const BodyState> before,
                                       std::span<const BodyState> after, double dt) const {
    std::optional<Touch> best;
    double least = apartForGood;
    for (const std::size_t own : ofBody_[body]) {
        for (const Reach& other : shapes_) {
            const std::size_t b = other.solid.body;
            if (!mayTouch(shapes_[own], other) || !isHere(before[b]) || !isHere(after[b])) continue;
            for (const std::span<const BodyState>& states : {before, after}) {
                const Transform here = poseIn(states[body]);
                const Vec2 way = wrap_.shortest(states[body].position, states[b].position);
                const Transform there{here.position + way, poseIn(states[b]).rotation};
                const double inReach = (states[body].velocity - states[b].velocity).norm() * dt + skin;
                const double centers = (here * shapes_[own].center - there * other.center).norm();
                if (centers > inReach + shapes_[own].radius + other.radius) continue;
                const Distance found = distance(shapes_[own].solid.shape.shape, here, other.solid.shape.shape, there);
                if (found.separation > inReach || found.separation >= least) continue;
                least = found.separation;
                best = Touch{b, found.normal};
            }
        }
    }
    return best;
}

std::set<std::pair<std::size_t, std::size_t>> Touching::pairs(std::span<const BodyState> states) const {
    std::vector<const Reach*> present;
    std::vector<Aabb> boxes;
    for (const Reach& shape : shapes_) {
        if (!isHere(states[shape.solid.body])) continue;
        Aabb box = aabbOf(shape.solid.shape.shape, poseIn(states[shape.solid.body]));
        box.lower -= Vec2::Constant(skin / 2);
        box.upper += Vec2::Constant(skin / 2);
        present.push_back(&shape);
        boxes.push_back(box);
    }
    Bvh tree;
    tree.build(boxes);
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (const Pair& pair : tree.pairs()) {
        const Reach &a = *present[pair.a], &b = *present[pair.b];
        if (!mayTouch(a, b)) continue;
        const double apart = distance(a.solid.shape.shape, poseIn(states[a.solid.body]), b.solid.shape.shape,
                                      poseIn(states[b.solid.body]))
                                 .separation;
        if (apart <= skin) found.insert(std::minmax(a.solid.body, b.solid.body));
    }
    return found;
}

double Touching::separation(std::size_t bodyA, std::size_t bodyB, std::span<const BodyState> states) const {
    double least = apartForGood;
    for (const std::size_t a : ofBody_[bodyA])
        for (const std::size_t b : ofBody_[bodyB])
            if (mayTouch(shapes_[a], shapes_[b]))
                least = std::min(least, distance(shapes_[a].solid.shape.shape, poseIn(states[bodyA]),
                                                 shapes_[b].solid.shape.shape, poseIn(states[bodyB]))
                                            .separation);
    return least;
}

bool Touching::isCrossed(std::size_t body, std::size_t through, std::span<const BodyState> states, const Vec2& from,
                         const Vec2& to) const {
    return std::ranges::any_of(ofBody_[body], [&](std::size_t wall) {
        const bool isSolid = std::ranges::any_of(
            ofBody_[through], [&](std::size_t own) { return mayTouch(shapes_[own], shapes_[wall]); });
        return isSolid && castRay(from, to, shapes_[wall].solid.shape.shape, poseIn(states[body])).has_value();
    });
}

}  // namespace plumb::compare
