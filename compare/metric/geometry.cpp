// SPDX-License-Identifier: MIT
#include <compare/metric/geometry.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/observation.h>
#include <plumb/collide/distance.h>

namespace plumb::compare {
namespace {

Transform poseOf(const BodyState& state) {
    return {state.position, Rot::fromAngle(state.angle)};
}

}  // namespace

Geometry::Geometry(const Scene& scene) : wrap_(scene.wrap), shapes_(solidShapes(scene)), joints_(scene) {
    for (const JointGeometry& joint : joints_.joints())
        if (!joint.collideConnected && joint.bodyA != noBody) keptApart_.insert(std::minmax(joint.bodyA, joint.bodyB));
    for (std::size_t i = 0; i < shapes_.size() && !anyMayTouch_; ++i)
        for (std::size_t j = 0; j < i && !anyMayTouch_; ++j) anyMayTouch_ = mayTouch(shapes_[i], shapes_[j]);
}

bool Geometry::mayTouch(const SolidShape& a, const SolidShape& b) const {
    return a.body != b.body && (a.dynamic || b.dynamic) && accepts(a.shape.filter, b.shape.filter) &&
           !keptApart_.contains(std::minmax(a.body, b.body));
}

std::optional<double> Geometry::penetration(std::span<const BodyState> states) const {
    if (!std::all_of(states.begin(), states.end(), isFinite)) return {};
    std::vector<Transform> poses;
    for (const BodyState& state : states) poses.push_back(poseOf(state));
    std::vector<const SolidShape*> present;
    std::vector<Aabb> boxes;
    for (const SolidShape& placed : shapes_) {
        if (!states[placed.body].present) continue;
        present.push_back(&placed);
        boxes.push_back(aabbOf(placed.shape.shape, poses[placed.body]));
    }
    Bvh tree;
    tree.build(boxes);
    double deepest = 0;
    const auto look = [&](const Pair& pair, const Vec2& shift) {
        const SolidShape& a = *present[pair.a];
        const SolidShape& b = *present[pair.b];
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
