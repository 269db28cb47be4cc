// SPDX-License-Identifier: MIT
#include <compare/scene/joint_geometry.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <compare/scene/name_index.h>

namespace plumb::compare {
namespace {

template <class Named>
std::size_t indexOf(const std::vector<Named>& list, const std::string& name, const std::string& what,
                    const Scene& scene) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Named& item) { return item.name == name; });
    if (found == list.end())
        throw std::invalid_argument("scene \"" + scene.name + "\": there is no " + what + " \"" + name + "\"");
    return static_cast<std::size_t>(found - list.begin());
}

std::optional<double> lengthOf(const DistanceJointDef& def) {
    return def.length.value_or((def.anchorB - def.anchorA).norm());
}
std::optional<double> lengthOf(const PulleyJointDef& def) {
    return (def.anchorA - def.groundA).norm() + def.ratio * (def.anchorB - def.groundB).norm();
}
std::optional<double> lengthOf(const auto&) {
    return {};
}

/// The points in the world where the joint holds the two bodies.
std::pair<Vec2, Vec2> anchorsOf(const auto& def, const Scene& scene, const JointGeometry& joint) {
    if constexpr (requires { def.anchor; })
        return {def.anchor, def.anchor};
    else if constexpr (requires { def.anchorA; })
        return {def.anchorA, def.anchorB};
    else  // at their origins
        return {scene.bodies[joint.bodyA].def.position, scene.bodies[joint.bodyB].def.position};
}

Transform intoFrame(const Scene& scene, std::size_t body) {
    return startPose(scene.bodies[body].def).inverse();
}

void place(JointGeometry& joint, const Scene& scene, const auto& def) {
    const auto [anchorA, anchorB] = anchorsOf(def, scene, joint);
    joint.localAnchorA = intoFrame(scene, joint.bodyA) * anchorA;
    joint.localAnchorB = intoFrame(scene, joint.bodyB) * anchorB;
    joint.length = lengthOf(def);
    if constexpr (requires { def.axis; })
        joint.localAxis = intoFrame(scene, joint.bodyA).rotation * Vec2(def.axis.normalized());
    if constexpr (requires { def.collideConnected; }) joint.collideConnected = def.collideConnected;
}

void place(JointGeometry& joint, const Scene& scene, const TargetJointDef& def) {
    joint.localAnchorA = def.target;
    joint.localAnchorB = intoFrame(scene, joint.bodyB) * def.anchor;
}

void place(JointGeometry&, const Scene&, const GearJointDef&) {}

}  // namespace

std::size_t bodyIndex(const Scene& scene, const std::string& name) {
    return indexOf(scene.bodies, name, "body", scene);
}

std::size_t jointIndex(const Scene& scene, const std::string& name) {
    return indexOf(scene.joints, name, "joint", scene);
}

Transform startPose(const BodyDef& def) {
    return {def.position, Rot::fromAngle(def.angle)};
}

Spring springOf(const TargetJointDef& def, const BodyDef& body) {
    if (def.spring) return *def.spring;
    const double mass = body.type == BodyType::Dynamic ? massOf(body).mass : 0;
    const double rate = 2 * std::numbers::pi * 5;
    return {mass * rate * rate, 2 * 0.7 * mass * rate};
}

Breaking breakingOf(const JointDef& def) {
    const auto its = [](const auto& d) {
        if constexpr (requires { d.breaking; })
            return d.breaking;
        else
            return Breaking{};
    };
    return std::visit(its, def);
}

std::vector<std::size_t> bodiesOf(const std::vector<JointGeometry>& joints, std::size_t joint) {
    const JointGeometry& held = joints[joint];
    if (std::holds_alternative<GearJointDef>(held.def)) {
        std::vector<std::size_t> bodies = bodiesOf(joints, held.jointA);
        for (const std::size_t body : bodiesOf(joints, held.jointB)) bodies.push_back(body);
        return bodies;
    }
    if (held.bodyA == noBody) return {held.bodyB};
    return {held.bodyA, held.bodyB};
}

std::vector<JointGeometry> jointGeometries(const Scene& scene) {
    const NameIndex index(scene.bodies);
    const auto find = [&](const std::string& name) {
        const std::optional<std::size_t> found = index.find(name);
        return found ? *found : bodyIndex(scene, name);  // this throws
    };
    std::vector<JointGeometry> result;
    result.reserve(scene.joints.size());
    for (const SceneJoint& joint : scene.joints) {
        JointGeometry geometry{.def = joint.def};
        if (std::holds_alternative<GearJointDef>(joint.def)) {
            geometry.jointA = jointIndex(scene, joint.jointA);
            geometry.jointB = jointIndex(scene, joint.jointB);
        } else if (std::holds_alternative<TargetJointDef>(joint.def)) {
            geometry.bodyB = find(joint.bodyA);
        } else {
            geometry.bodyA = find(joint.bodyA);
            geometry.bodyB = find(joint.bodyB);
        }
        std::visit([&](const auto& def) { place(geometry, scene, def); }, joint.def);
        result.push_back(std::move(geometry));
    }
    return result;
}

}  // namespace plumb::compare
