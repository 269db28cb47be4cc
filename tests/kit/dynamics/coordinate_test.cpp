// SPDX-License-Identifier: MIT
// Is a joint's coordinate a number, wherever its bodies are?
#include <cmath>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"

using namespace plumb;

namespace {

/// Two discs with a joint of each kind that has a coordinate.
struct Jointed {
    World world;
    BodyId a, b;
    std::vector<JointId> joints;
};

Jointed jointed() {
    Jointed j;
    const BodyId a = j.a = j.world.add({.shapes = {circle(0.5)}});
    const BodyId b = j.b = j.world.add({.position = {2, 0}, .shapes = {circle(0.5)}});
    const Vec2 middle(1, 0);
    j.joints = {
        j.world.join(RevoluteJointDef{.bodyA = a, .bodyB = b, .anchor = middle}),
        j.world.join(PrismaticJointDef{.bodyA = a, .bodyB = b, .anchor = middle, .axis = {3, 4}}),
        j.world.join(DistanceJointDef{.bodyA = a, .bodyB = b, .anchorB = {2, 0}}),
        j.world.join(WeldJointDef{.bodyA = a, .bodyB = b, .anchor = middle}),
        j.world.join(WheelJointDef{.bodyA = a, .bodyB = b, .anchor = middle, .axis = {-3, 4}}),
        j.world.join(PulleyJointDef{.bodyA = a, .bodyB = b, .groundA = {0, 3}, .groundB = {2, 3}, .anchorB = {2, 0}}),
        j.world.join(MotorJointDef{.bodyA = a, .bodyB = b})};
    j.joints.push_back(j.world.join(GearJointDef{.jointA = j.joints[0], .jointB = j.joints[1], .ratio = -1000}));
    return j;
}

}  // namespace

TEST_CASE("a joint's coordinate, speed and errors are numbers when its bodies are 1e10 to 1e308 m away and as fast",
          "[dynamics]") {
    for (const double size : {1e10, 1e20, 1e155, 1e200, 1e308}) {
        for (const double sign : {1.0, -1.0}) {
            Jointed j = jointed();
            j.world.body(j.a).setPose({size, -sign * size}, size);
            j.world.body(j.b).setPose({-size, sign * size}, -size);
            j.world.body(j.a).setVelocity({size, sign * size});
            j.world.body(j.b).setVelocity({-size, sign * -size});
            j.world.body(j.a).setAngularVelocity(size);
            j.world.body(j.b).setAngularVelocity(-size);
            for (int step = 0; step < 3; ++step) {
                for (std::size_t i = 0; i < j.joints.size(); ++i) {
                    INFO("joint " << i << " at " << size << " m, step " << step);
                    const auto joint = j.world.joint(j.joints[i]);
                    CHECK(std::isfinite(joint.coordinate().value));
                    CHECK(std::isfinite(joint.coordinate().speed));
                    CHECK(std::isfinite(joint.error()));
                    CHECK(std::isfinite(joint.angleError()));
                }
                j.world.step(1.0 / 60);
            }
        }
    }
}
