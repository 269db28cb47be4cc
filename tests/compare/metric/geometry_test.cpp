// SPDX-License-Identifier: MIT
#include <compare/metric/geometry.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

constexpr double geometryRounding = 1e-12;  // of lengths of a few metres

/// Two discs of 0.5 m, 2 m apart on the x axis, without gravity.
Scene twoDiscs() {
    Scene scene = oneDisc();
    scene.gravity = {0, 0};
    scene.bodies[0].def.velocity = {0, 0};
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "other";
    scene.bodies[1].def.position = {2, 0};
    scene.closedForm.reset();
    return scene;
}

std::vector<BodyState> apart(double distance) {
    return {at(0, 0), at(distance, 0)};
}

SceneJoint rod(bool collideConnected) {
    DistanceJointDef def;
    def.anchorA = {0, 0};
    def.anchorB = {2, 0};
    def.collideConnected = collideConnected;
    return {"rod", "disc", "other", def};
}

}  // namespace

TEST_CASE("discs of 0.5 m whose centres are 0.9 m apart overlap by 0.1 m, at 1.1 m not at all", "[compare][metric]") {
    const Geometry geometry(twoDiscs());
    CHECK(geometry.anyMayTouch());
    CHECK_THAT(*geometry.penetration(apart(0.9)), WithinAbs(0.1, geometryRounding));
    CHECK(*geometry.penetration(apart(1.1)) == 0);
    CHECK_FALSE(geometry.penetration(apart(nan)));
}

TEST_CASE("bodies that a filter or a joint keeps from colliding may overlap", "[compare][metric]") {
    Scene filtered = twoDiscs();
    filtered.bodies[0].def.shapes[0].filter.mask = 2;
    CHECK_FALSE(Geometry(filtered).anyMayTouch());
    CHECK(*Geometry(filtered).penetration(apart(0.5)) == 0);

    Scene joined = twoDiscs();
    joined.joints = {rod(false)};
    CHECK(*Geometry(joined).penetration(apart(0.5)) == 0);
    joined.joints = {rod(true)};
    CHECK_THAT(*Geometry(joined).penetration(apart(0.5)), WithinAbs(0.5, geometryRounding));
}

TEST_CASE("a common group decides before masks do: above 0 they collide, below 0 they may overlap",
          "[compare][metric]") {
    Scene scene = twoDiscs();
    for (const int group : {1, -1}) {
        for (SceneBody& body : scene.bodies) {
            body.def.shapes[0].filter.group = group;
            body.def.shapes[0].filter.mask = group > 0 ? 0 : ~std::uint64_t{0};
        }
        CHECK(Geometry(scene).anyMayTouch() == (group > 0));
    }
    scene.bodies[0].def.shapes[0].filter.group = -2;  // of two groups: the masks decide
    CHECK(Geometry(scene).anyMayTouch());
}

TEST_CASE("two static bodies may overlap, and the two shapes of one body", "[compare][metric]") {
    Scene scene = twoDiscs();
    for (SceneBody& body : scene.bodies) body.def.type = BodyType::Static;
    CHECK_FALSE(Geometry(scene).anyMayTouch());
    Scene one = oneDisc();
    one.bodies[0].def.shapes.push_back(circle(0.4));
    CHECK_FALSE(Geometry(one).anyMayTouch());
}

TEST_CASE("a rod of 2 m between bodies 2.25 m apart is torn by 0.25 m", "[compare][metric]") {
    Scene scene = twoDiscs();
    scene.joints = {rod(false)};
    const Geometry geometry(scene);
    CHECK(geometry.anyJoint());
    CHECK_THAT(*geometry.jointError(apart(2)), WithinAbs(0, geometryRounding));
    CHECK_THAT(*geometry.jointError(apart(2.25)), WithinAbs(0.25, geometryRounding));
    CHECK_THAT(*geometry.jointError(apart(1.75)), WithinAbs(0.25, geometryRounding));
    CHECK_FALSE(geometry.jointError(apart(infinity)));
}

TEST_CASE("a rod with a length of its own is measured by that", "[compare][metric]") {
    Scene scene = twoDiscs();
    SceneJoint joint = rod(false);
    std::get<DistanceJointDef>(joint.def).length = 1.5;
    scene.joints = {joint};
    CHECK_THAT(*Geometry(scene).jointError(apart(2)), WithinAbs(0.5, geometryRounding));
}

TEST_CASE("a hinge 1 m from both bodies is torn by what one of them moves, and not by a turn about it",
          "[compare][metric]") {
    Scene scene = twoDiscs();
    RevoluteJointDef hinge;
    hinge.anchor = {1, 0};
    scene.joints = {{"hinge", "disc", "other", hinge}};
    const Geometry geometry(scene);
    std::vector<BodyState> states = apart(2);
    CHECK_THAT(*geometry.jointError(states), WithinAbs(0, geometryRounding));
    states[1].position.y() = 0.125;
    CHECK_THAT(*geometry.jointError(states), WithinAbs(0.125, geometryRounding));
    // the other disc a quarter turn about the hinge: its anchor (-1, 0) points down, it stands above
    states[1] = at(1, 1);
    states[1].angle = 1.5707963267948966;
    CHECK_THAT(*geometry.jointError(states), WithinAbs(0, geometryRounding));
}

TEST_CASE("a joint that has broken is torn no longer", "[compare][metric]") {
    Scene scene = twoDiscs();
    scene.joints = {rod(false)};
    CHECK_THAT(*Geometry(scene).jointError(apart(5), {false}), WithinAbs(3, geometryRounding));
    CHECK(*Geometry(scene).jointError(apart(5), {true}) == 0);
}

TEST_CASE("what is in a sensor, passes a one-way shape or is not enabled overlaps rightly", "[compare][metric]") {
    for (int which = 0; which < 3; ++which) {
        Scene scene = twoDiscs();
        if (which == 0) scene.bodies[0].def.shapes[0].sensor = true;
        if (which == 1) scene.bodies[0].def.shapes[0].oneWay = Vec2(0, 1);
        if (which == 2) scene.bodies[0].def.enabled = false;
        CHECK_FALSE(Geometry(scene).anyMayTouch());
        CHECK(*Geometry(scene).penetration(apart(0.5)) == 0);
    }
}

}  // namespace plumb::compare
