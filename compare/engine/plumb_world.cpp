// SPDX-License-Identifier: MIT
#include <compare/engine/plumb_world.h>

#include <compare/engine/arrivals.h>
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

void putBody(PlumbWorld& made, const Scene& scene, std::size_t body) {
    made.bodies[body] = made.world.add(scene.bodies[body].def);
}

void putJoint(PlumbWorld& made, const JointGeometry& geometry, std::size_t joint) {
    made.joints[joint] = made.world.join(withIds(geometry, made));
}

PlumbWorld plumbWorld(const Scene& scene, WorldDef def) {
    def.gravity = scene.gravity;
    def.sleeping = scene.sleeping;
    def.wrap = scene.wrap;
    PlumbWorld made{World(def), {}, {}, jointGeometries(scene)};
    made.world.reserve(capacityFor(scene));
    made.bodies.resize(scene.bodies.size());
    made.joints.resize(scene.joints.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (bodyIsThereAtStart(scene, i)) putBody(made, scene, i);
    for (std::size_t i = 0; i < made.geometries.size(); ++i)
        if (jointIsThereAtStart(scene, made.geometries, i)) putJoint(made, made.geometries[i], i);
    for (const SceneField& field : scene.fields) {
        FieldDef law = field.def;
        if (auto* magnet = std::get_if<Magnet>(&law.law)) magnet->body = made.bodies[bodyIndex(scene, field.body)];
        made.world.addField(law);
    }
    return made;
}

}  // namespace plumb::compare
