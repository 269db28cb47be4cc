// SPDX-License-Identifier: MIT
#include <compare/engine/plumb_world.h>

#include <compare/engine/joint_geometry.h>
#include <plumb/shapes/chain.h>

namespace plumb::compare {
namespace {

JointDef withIds(const JointGeometry& joint, const PlumbWorld& made) {
    JointDef def = joint.def;
    const auto name = [&](auto& d) {
        if constexpr (requires { d.bodyA; }) {
            d.bodyA = made.bodies[joint.bodyA];
            d.bodyB = made.bodies[joint.bodyB];
        } else if constexpr (requires { d.jointA; }) {
            d.jointA = made.joints[joint.jointA];
            d.jointB = made.joints[joint.jointB];
        } else {
            d.body = made.bodies[joint.bodyB];
        }
    };
    std::visit(name, def);
    return def;
}

Capacity capacityFor(const Scene& scene) {
    Capacity capacity{.bodies = scene.bodies.size(), .joints = scene.joints.size()};
    for (const SceneBody& body : scene.bodies)
        for (const ShapeDef& shape : body.def.shapes) capacity.shapes += piecesOf(shape.shape).size();
    return capacity;
}

}  // namespace

PlumbWorld plumbWorld(const Scene& scene, WorldDef def) {
    def.gravity = scene.gravity;
    def.sleeping = scene.sleeping;
    def.wrap = scene.wrap;
    PlumbWorld made{World(def), {}, {}};
    made.world.reserve(capacityFor(scene));
    for (const SceneBody& body : scene.bodies) made.bodies.push_back(made.world.add(body.def));
    for (const JointGeometry& joint : jointGeometries(scene))
        made.joints.push_back(made.world.join(withIds(joint, made)));
    for (const SceneField& field : scene.fields) {
        FieldDef law = field.def;
        if (auto* magnet = std::get_if<Magnet>(&law.law)) magnet->body = made.bodies[bodyIndex(scene, field.body)];
        made.world.addField(law);
    }
    return made;
}

}  // namespace plumb::compare
