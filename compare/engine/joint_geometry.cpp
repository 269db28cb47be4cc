// SPDX-License-Identifier: MIT
#include <compare/engine/joint_geometry.h>

#include <algorithm>
#include <stdexcept>

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

struct Anchors {
    Vec2 a, b;  // in the world [m]
    std::optional<double> length;
    bool collideConnected;
};

Anchors anchorsOf(const RevoluteJointDef& def) {
    return {def.anchor, def.anchor, {}, def.collideConnected};
}

Anchors anchorsOf(const DistanceJointDef& def) {
    const double apart = (def.anchorB - def.anchorA).norm();
    return {def.anchorA, def.anchorB, def.length.value_or(apart), def.collideConnected};
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
    std::vector<JointGeometry> result;
    result.reserve(scene.joints.size());
    for (const SceneJoint& joint : scene.joints) {
        const Anchors anchors = std::visit([](const auto& def) { return anchorsOf(def); }, joint.def);
        const std::size_t a = bodyIndex(scene, joint.bodyA);
        const std::size_t b = bodyIndex(scene, joint.bodyB);
        result.push_back({a, b, startPose(scene.bodies[a].def).inverse() * anchors.a,
                          startPose(scene.bodies[b].def).inverse() * anchors.b, anchors.length,
                          anchors.collideConnected});
    }
    return result;
}

}  // namespace plumb::compare
