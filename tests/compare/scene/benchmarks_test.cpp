// SPDX-License-Identifier: MIT
#include <compare/scene/builtin.h>

#include <algorithm>
#include <cmath>

#include <compare/closed_form/oracle.h>
#include <compare/metric/mechanics.h>

#include "catch.h"

namespace plumb::compare {
namespace {

std::vector<BodyState> firstStatesOf(const Scene& scene) {
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies)
        states.push_back({body.def.position, body.def.angle, body.def.velocity, body.def.angularVelocity});
    return states;
}

Vec2 velocityAt(const Scene& scene, const std::string& body, const Vec2& point) {
    const BodyDef& def = std::ranges::find(scene.bodies, body, &SceneBody::name)->def;
    return def.velocity + def.angularVelocity * perp(Vec2(point - def.position));
}

}  // namespace

TEST_CASE("the double four-bar starts with 1.5 J and 34.335 J, and no hinge is pulled apart", "[compare][scene][law]") {
    const Scene scene = findScene("double_four_bar").value();
    const Mechanics start = MassModel(scene).at(firstStatesOf(scene)).value();
    // Three uprights of m l^2 / 3 at 1 rad/s, two tops at 1 m/s; three at half a metre, two at one.
    CHECK(std::abs(start.kinetic - 1.5) < 1e-14);
    CHECK(std::abs(start.potential - 3.5 * 9.81) < 1e-13);
    REQUIRE(scene.joints.size() == 7);
    for (const SceneJoint& joint : scene.joints) {
        INFO(joint.name);
        const Vec2 anchor = std::get<RevoluteJointDef>(joint.def).anchor;
        CHECK((velocityAt(scene, joint.bodyA, anchor) - velocityAt(scene, joint.bodyB, anchor)).norm() < 1e-15);
    }
}

TEST_CASE("the level pendulum takes 1.18034 times as long as a small swing", "[compare][scene][law]") {
    const Scene scene = findScene("pendulum_horizontal").value();
    const double period = 1.1803405990161 * 2.0060666807106475;  // 1 / AGM(1, cos 45 deg), and 2 pi sqrt(1 / 9.81)
    CHECK((closedFormStates(scene, 0).at(1).position - Vec2(-1, 0)).norm() < 1e-12);
    CHECK((closedFormStates(scene, period / 4).at(1).position - Vec2(0, -1)).norm() < 1e-12);
    CHECK((closedFormStates(scene, period / 2).at(1).position - Vec2(1, 0)).norm() < 1e-12);
}

}  // namespace plumb::compare
