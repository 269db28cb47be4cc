// SPDX-License-Identifier: MIT
#include "kit/dynamics/sound_defs.h"

namespace plumb::test {

std::vector<JointDef> soundJoints(const Bench& bench) {
    const BodyId a = bench.wall, b = bench.ball;
    const Vec2 at{0, 4}, beside{0.3, 4};
    const Spring soft{20, 1};
    return {
        RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = at, .motorSpeed = 1, .maxMotorTorque = 1},
        RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = at, .spring = soft},
        PrismaticJointDef{.bodyA = a, .bodyB = b, .anchor = at, .motorSpeed = 1, .maxMotorForce = 1},
        PrismaticJointDef{.bodyA = a, .bodyB = b, .anchor = at, .spring = soft},
        DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = at, .anchorB = beside},
        DistanceJointDef{.bodyA = a, .bodyB = b, .anchorA = at, .anchorB = beside, .spring = soft, .maxMotorForce = 1},
        WeldJointDef{.bodyA = a, .bodyB = b, .anchor = at},
        WheelJointDef{.bodyA = a, .bodyB = b, .anchor = at, .spring = soft, .motorSpeed = 1, .maxMotorTorque = 1},
        PulleyJointDef{.bodyA = a, .bodyB = b, .groundA = {0, 7}, .groundB = {2, 7}, .anchorA = at, .anchorB = {2, 4}},
        GearJointDef{.jointA = bench.hinge, .jointB = bench.slide},
        MotorJointDef{.bodyA = a, .bodyB = b, .maxForce = 10, .maxTorque = 10},
        TargetJointDef{.body = b, .anchor = at, .target = {1, 5}},
        FilterJointDef{a, b},
    };
}

BodyDef soundBody() {
    BodyDef body{.position = {2, 8}, .velocity = {1, 0}};
    for (const ShapeDef& shape : soundShapes()) body.shapes.push_back(shape);
    return body;
}

std::vector<ShapeDef> soundShapes() {
    return {circle(0.4), capsule({-0.5, 0}, {0.5, 0}, 0.5), box({0.5, 0.5}), segment({0, 0}, {1, 0}),
            chain({{0, 0}, {1, 0}, {2, 0}})};
}

std::vector<FieldDef> soundFields(BodyId carrier) {
    std::vector<FieldDef> fields;
    forEachAlternative(std::type_identity<FieldLaw>(), [&](const auto& law) {
        FieldDef def{.law = law};
        if (auto* magnet = std::get_if<Magnet>(&def.law)) magnet->body = carrier;
        fields.push_back(def);
    });
    return fields;
}

}  // namespace plumb::test
