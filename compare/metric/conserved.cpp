// SPDX-License-Identifier: MIT
#include <compare/metric/conserved.h>

#include <algorithm>
#include <map>

#include <compare/metric/geometry.h>
#include <compare/scene/joint_geometry.h>
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

bool isFreeOfLosses(const SceneBody& body) {
    const BodyDef& def = body.def;
    return isAlwaysThere(body) && def.linearDamping == 0 && def.angularDamping == 0 && def.type != BodyType::Kinematic;
}

bool isElastic(const SceneBody& body) {
    return std::ranges::all_of(body.def.shapes, [](const ShapeDef& shape) {
        const Material& material = shape.material;
        return material.restitution == 1 && material.friction == 0 && material.rollingResistance == 0;
    });
}

bool isUndamped(const std::optional<Spring>& spring) {
    return !spring || spring->damping == 0;
}

bool isLossless(const SceneJoint& joint) {
    const Breaking breaking = breakingOf(joint.def);
    if (breaking.force < unlimited || breaking.torque < unlimited) return false;
    return std::visit(
        [](const auto& def) {
            using Def = std::remove_cvref_t<decltype(def)>;
            bool kept = !std::is_same_v<Def, MotorJointDef> && !std::is_same_v<Def, TargetJointDef>;
            if constexpr (requires { def.maxMotorTorque; }) kept = kept && def.maxMotorTorque == 0;
            if constexpr (requires { def.maxMotorForce; }) kept = kept && def.maxMotorForce == 0;
            if constexpr (requires { def.limit; }) kept = kept && !def.limit;
            if constexpr (requires { def.spring; }) kept = kept && isUndamped(def.spring);
            if constexpr (requires { def.bending; }) kept = kept && isUndamped(def.bending);
            if constexpr (requires { def.maxLength; })
                kept = kept && (!def.spring || (def.minLength == 0 && def.maxLength == unlimited));
            return kept;
        },
        joint.def);
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

bool keepsEnergy(const Scene& scene) {
    if (!scene.fields.empty() || !scene.movers.empty()) return false;
    return std::ranges::all_of(scene.bodies, isFreeOfLosses) && std::ranges::all_of(scene.joints, isLossless) &&
           (!Geometry(scene).anyMayTouch() || std::ranges::all_of(scene.bodies, isElastic));
}

}  // namespace plumb::compare
