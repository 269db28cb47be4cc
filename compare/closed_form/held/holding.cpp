// SPDX-License-Identifier: MIT
#include <compare/closed_form/held/holding.h>

#include <compare/closed_form/free/free_body.h>

namespace plumb::compare {
namespace {

bool stays(const BodyDef& def) {
    return def.type == BodyType::Static ||
           (def.type == BodyType::Kinematic && def.velocity == Vec2(0, 0) && def.angularVelocity == 0);
}

}  // namespace

HeldBody heldBodyOf(const Scene& scene, const std::string& name, const std::string& named) {
    HeldBody body;
    body.index = bodyIndex(scene, name);
    body.scene = &scene.bodies[body.index];
    const BodyDef& def = body.scene->def;
    if (def.type != BodyType::Dynamic || !def.enabled) notKnown(name, "it is not a body that forces move");
    if (def.lockX || def.lockY) notKnown(name, "it is locked");
    if (def.linearDamping > 0 || def.angularDamping > 0) notKnown(name, "it is damped");
    for (const SceneField& field : scene.fields)
        if (field.name != named && actsOn(field, *body.scene))
            notKnown(name, "the field " + field.name + " acts on it");
    body.mass = massOf(def);
    body.center = startPose(def) * body.mass.center;
    body.gravity = def.gravityScale * scene.gravity;
    return body;
}

std::vector<Holding> holdingsOf(const Scene& scene, const HeldBody& body) {
    std::vector<Holding> holdings;
    const std::vector<JointGeometry> joints = jointGeometries(scene);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const JointGeometry& joint = joints[i];
        if (joint.bodyA != body.index && joint.bodyB != body.index) continue;
        const bool isB = joint.bodyB == body.index;
        const std::size_t other = isB ? joint.bodyA : joint.bodyB;
        if (other == noBody || !stays(scene.bodies[other].def))
            notKnown(body.scene->name, "the joint " + scene.joints[i].name + " holds it to what does not stay");
        const Vec2 own = startPose(body.scene->def) * (isB ? joint.localAnchorB : joint.localAnchorA);
        const Vec2 far = startPose(scene.bodies[other].def) * (isB ? joint.localAnchorA : joint.localAnchorB);
        holdings.push_back({i, far, own});
    }
    return holdings;
}

double downwardGravity(const HeldBody& body) {
    if (body.gravity.x() != 0 || body.gravity.y() >= 0) notKnown(body.scene->name, "gravity is not straight down");
    return -body.gravity.y();
}

}  // namespace plumb::compare
