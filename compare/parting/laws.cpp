// SPDX-License-Identifier: MIT
#include <compare/parting/laws.h>

#include <algorithm>

#include <compare/scene/joint_geometry.h>
#include <compare/metric/geometry.h>

namespace plumb::compare {
namespace {

bool isFree(const SceneBody& body) {
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

bool keepsEnergy(const Scene& scene) {
    if (!scene.fields.empty() || !scene.movers.empty()) return false;
    return std::ranges::all_of(scene.bodies, isFree) && std::ranges::all_of(scene.joints, isLossless) &&
           (!Geometry(scene).anyMayTouch() || std::ranges::all_of(scene.bodies, isElastic));
}

}  // namespace plumb::compare
