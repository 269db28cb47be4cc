// SPDX-License-Identifier: MIT
#include <compare/engine/joint_geometry.h>

#include <algorithm>
#include <stdexcept>

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

JointGeometry geometryOf(const RevoluteJointDef& def, std::size_t a, std::size_t b, const Transform& intoA,
                         const Transform& intoB) {
    return {a, b, intoA * def.anchor, intoB * def.anchor, {}, def.motorSpeed, def.maxMotorTorque, def.collideConnected};
}

JointGeometry geometryOf(const DistanceJointDef& def, std::size_t a, std::size_t b, const Transform& intoA,
                         const Transform& intoB) {
    const double apart = (def.anchorB - def.anchorA).norm();
    return {a, b, intoA * def.anchorA, intoB * def.anchorB, def.length.value_or(apart), 0, 0, def.collideConnected};
}

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

std::vector<JointGeometry> jointGeometries(const Scene& scene) {
    const NameIndex index(scene.bodies);
    const auto find = [&](const std::string& name) {
        const std::optional<std::size_t> found = index.find(name);
        return found ? *found : bodyIndex(scene, name);  // which throws
    };
    std::vector<JointGeometry> result;
    result.reserve(scene.joints.size());
    for (const SceneJoint& joint : scene.joints) {
        const std::size_t a = find(joint.bodyA);
        const std::size_t b = find(joint.bodyB);
        const Transform intoA = startPose(scene.bodies[a].def).inverse();
        const Transform intoB = startPose(scene.bodies[b].def).inverse();
        result.push_back(std::visit([&](const auto& def) { return geometryOf(def, a, b, intoA, intoB); }, joint.def));
    }
    return result;
}

}  // namespace plumb::compare
