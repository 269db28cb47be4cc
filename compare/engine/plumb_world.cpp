// SPDX-License-Identifier: MIT
#include <compare/engine/plumb_world.h>

#include <compare/engine/joint_geometry.h>

namespace plumb::compare {
namespace {

JointDef withIds(JointDef def, const BodyId& a, const BodyId& b) {
    std::visit(
        [&](auto& d) {
            d.bodyA = a;
            d.bodyB = b;
        },
        def);
    return def;
}

}  // namespace

PlumbWorld plumbWorld(const Scene& scene, const SolverSettings& solver) {
    PlumbWorld made{World({.gravity = scene.gravity, .sleeping = scene.sleeping, .solver = solver}), {}, {}};
    for (const SceneBody& body : scene.bodies) made.bodies.push_back(made.world.add(body.def));
    const std::vector<JointGeometry> joints = jointGeometries(scene);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const BodyId a = made.bodies[joints[i].bodyA], b = made.bodies[joints[i].bodyB];
        made.joints.push_back(made.world.join(withIds(scene.joints[i].def, a, b)));
    }
    return made;
}

}  // namespace plumb::compare
