// SPDX-License-Identifier: MIT
#include <compare/metric/conserved.h>

#include <algorithm>
#include <map>

#include <compare/scene/shape_pair.h>

namespace plumb::compare {
namespace {

bool isDynamic(const SceneBody& body) {
    return body.def.type == BodyType::Dynamic;
}

/// Is it there from start to end, and pushed only by what meets it?
bool isFree(const SceneBody& body, const Vec2& gravity) {
    const BodyDef& def = body.def;
    const bool hasWeight = def.gravityScale != 0 && gravity != Vec2(0, 0);
    const bool isDamped = def.linearDamping > 0 || def.angularDamping > 0;
    const bool isHeld = def.fixedRotation || def.lockX || def.lockY;
    return isAlwaysThere(body) && !hasWeight && !isDamped && !isHeld;
}

bool mayTouch(const BodyDef& a, const BodyDef& b) {
    return std::ranges::any_of(a.shapes, [&](const ShapeDef& ofA) {
        return std::ranges::any_of(b.shapes, [&](const ShapeDef& ofB) {
            return !ofA.sensor && !ofB.sensor && accepts(ofA.filter, ofB.filter);
        });
    });
}

/// Does the joint push bodies only against each other, and are both dynamic?
bool isInside(const SceneJoint& joint, const std::map<std::string, bool>& dynamic) {
    if (std::holds_alternative<FilterJointDef>(joint.def) || std::holds_alternative<GearJointDef>(joint.def))
        return true;
    if (std::holds_alternative<PulleyJointDef>(joint.def) || joint.bodyB.empty()) return false;
    return dynamic.at(joint.bodyA) && dynamic.at(joint.bodyB);
}

bool asksFor(const Scene& scene, const std::string& metric) {
    return std::ranges::any_of(scene.checks, [&](const Check& check) {
        const auto* invariant = std::get_if<InvariantCheck>(&check);
        return invariant != nullptr && invariant->metric == metric;
    });
}

bool isIsolated(const Scene& scene) {
    const auto isOwnGravity = [](const SceneField& field) {
        return std::holds_alternative<MutualGravity>(field.def.law);
    };
    if (!scene.movers.empty() || !std::ranges::all_of(scene.fields, isOwnGravity)) return false;
    std::map<std::string, bool> dynamic;
    for (const SceneBody& body : scene.bodies) {
        dynamic[body.name] = isDynamic(body);
        if (isDynamic(body) && !isFree(body, scene.gravity)) return false;
        if (isDynamic(body)) continue;
        for (const SceneBody& other : scene.bodies)
            if (isDynamic(other) && mayTouch(body.def, other.def)) return false;
    }
    return std::ranges::all_of(scene.joints, [&](const SceneJoint& joint) { return isInside(joint, dynamic); });
}

}  // namespace

std::vector<std::string> conservedMomenta(const Scene& scene) {
    const bool isolated = isIsolated(scene);
    std::vector<std::string> conserved;
    if (isolated || asksFor(scene, "momentum_drift")) conserved.push_back("momentum_drift");
    if ((isolated && !scene.wrap.any()) || asksFor(scene, "angular_momentum_drift"))
        conserved.push_back("angular_momentum_drift");
    return conserved;
}

}  // namespace plumb::compare
