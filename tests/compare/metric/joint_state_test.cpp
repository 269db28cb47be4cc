// SPDX-License-Identifier: MIT
#include <compare/metric/joint_state.h>

#include <cmath>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

constexpr double jointRounding = 1e-12;  // of a few metres
constexpr double quarter = 1.5707963267948966;

/// A post at the origin that is turned by a quarter, and a disc of 2 kg at (2, 0).
Scene joined(const JointDef& def) {
    Scene scene = oneDisc();
    scene.closedForm.reset();
    scene.bodies.insert(scene.bodies.begin(), {"post", {.type = BodyType::Static, .angle = quarter}});
    scene.bodies[1].def.position = {2, 0};
    scene.joints = {{"joint", "post", "disc", def}};
    if (std::holds_alternative<TargetJointDef>(def)) scene.joints[0] = {"joint", "disc", "", def};
    return scene;
}

/// The disc somewhere else.
std::vector<BodyState> discAt(double x, double y, double angle = 0) {
    BodyState post = at(0, 0), disc = at(x, y);
    post.angle = quarter;
    disc.angle = angle;
    return {post, disc};
}

double gap(const JointDef& def, const std::vector<BodyState>& states) {
    return JointStates(joined(def)).gap(0, states);
}

double energy(const JointDef& def, const std::vector<BodyState>& states) {
    return JointStates(joined(def)).springEnergy(0, states);
}

}  // namespace

TEST_CASE("a slide is torn across its axis and beyond its limit, and free along it", "[compare][metric]") {
    PrismaticJointDef slide{.anchor = {2, 0}, .axis = {3, 0}};
    CHECK_THAT(gap(slide, discAt(7, 0)), WithinAbs(0, jointRounding));
    CHECK_THAT(gap(slide, discAt(7, -0.25)), WithinAbs(0.25, jointRounding));
    slide.limit = Limit{-1, 4};
    CHECK_THAT(gap(slide, discAt(6.5, 0)), WithinAbs(0.5, jointRounding));
    CHECK_THAT(gap(slide, discAt(0.5, 0)), WithinAbs(0.5, jointRounding));
    CHECK_THAT(gap(slide, discAt(6.3, 0.4)), WithinAbs(0.5, jointRounding));
    CHECK_THAT(gap(WheelJointDef{.anchor = {2, 0}, .axis = {1, 0}}, discAt(3, 0.5, 9)), WithinAbs(0.5, jointRounding));
}

TEST_CASE("a spring is torn only beyond its shortest and its longest", "[compare][metric]") {
    const DistanceJointDef spring{.anchorB = {2, 0}, .spring = Spring{}, .minLength = 1, .maxLength = 3};
    CHECK(gap(spring, discAt(2.9, 0)) == 0);
    CHECK_THAT(gap(spring, discAt(0, 3.25)), WithinAbs(0.25, jointRounding));
    CHECK_THAT(gap(spring, discAt(0, 0.5)), WithinAbs(0.5, jointRounding));
}

TEST_CASE("a stiff weld is torn by what its anchors are apart, one that gives is not", "[compare][metric]") {
    CHECK_THAT(gap(WeldJointDef{.anchor = {1, 0}}, discAt(2, 0.5)), WithinAbs(0.5, jointRounding));
    CHECK(gap(WeldJointDef{.anchor = {1, 0}, .spring = Spring{}}, discAt(2, 0.5)) == 0);
}

TEST_CASE("a pulley is torn when its rope is too long, and not when it is slack", "[compare][metric]") {
    Scene scene = joined(PulleyJointDef{
        .groundA = {0, 5}, .groundB = {2, 5}, .anchorA = {0, 0}, .anchorB = {2, 0}, .ratio = 2});  // 5 + 2 * 5
    const JointStates joints(scene);
    std::vector<BodyState> states = discAt(2, -1);
    CHECK_THAT(joints.gap(0, states), WithinAbs(2, jointRounding));
    states[0].position.y() = 2;  // two up for one down
    CHECK_THAT(joints.gap(0, states), WithinAbs(0, jointRounding));
    states[0].position.y() = 3;
    CHECK(joints.gap(0, states) == 0);
}

TEST_CASE("a gear's rack is torn by what it is from where its wheel should have it", "[compare][metric]") {
    Scene scene = joined(PrismaticJointDef{.anchor = {2, 0}});
    scene.bodies.push_back({"wheel", {.position = {5, 0}, .shapes = {circle(0.5)}}});
    scene.joints.push_back({"axle", "post", "wheel", RevoluteJointDef{.anchor = {5, 0}}});
    scene.joints.push_back({.name = "gear", .def = GearJointDef{.ratio = 0.5}, .jointA = "joint", .jointB = "axle"});
    std::vector<BodyState> states = discAt(1.5, 0);  // the rack by -0.5: the wheel should be at 1
    states.push_back(at(5, 0));
    states[2].angle = 1.25;
    CHECK_THAT(JointStates(scene).gap(2, states), WithinAbs(0.125, jointRounding));
    std::swap(scene.joints[2].jointA, scene.joints[2].jointB);  // wheel + 0.5 rack: 1.25 - 0.25, over 0.5
    CHECK_THAT(JointStates(scene).gap(2, states), WithinAbs(2, jointRounding));
}

TEST_CASE("what pulls or only forbids touching is never torn", "[compare][metric]") {
    CHECK(gap(MotorJointDef{}, discAt(9, 9)) == 0);
    CHECK(gap(TargetJointDef{.target = {1, 1}}, discAt(9, 9)) == 0);
    CHECK(gap(FilterJointDef{}, discAt(9, 9)) == 0);
}

TEST_CASE("a hinge is beyond its limit by angle, counted from the start, a slide by shift", "[compare][metric]") {
    const JointStates hinge(joined(RevoluteJointDef{.anchor = {2, 0}, .limit = Limit{-0.5, 1}}));
    CHECK(hinge.beyondLimit(0, discAt(2, 0, 0.9)) == 0);
    CHECK_THAT(hinge.beyondLimit(0, discAt(2, 0, 1.25)), WithinAbs(0.25, jointRounding));
    CHECK_THAT(hinge.beyondLimit(0, discAt(2, 0, -0.75)), WithinAbs(0.25, jointRounding));
    const JointStates slide(joined(PrismaticJointDef{.anchor = {2, 0}, .limit = Limit{0, 1}}));
    CHECK_THAT(slide.beyondLimit(0, discAt(3.5, 0)), WithinAbs(0.5, jointRounding));
    CHECK(JointStates(joined(WeldJointDef{})).beyondLimit(0, discAt(9, 9)) == 0);
}

TEST_CASE("springs of 8 N/m that are 0.5 m off hold 1 J, whatever kind of joint they are in", "[compare][metric]") {
    const Spring spring{8, 3};
    CHECK_THAT(energy(DistanceJointDef{.anchorB = {2, 0}, .spring = spring}, discAt(0, 2.5)),
               WithinAbs(1, jointRounding));
    CHECK_THAT(energy(DistanceJointDef{.anchorB = {2, 0}, .length = 1, .spring = spring}, discAt(1.5, 0)),
               WithinAbs(1, jointRounding));
    CHECK_THAT(energy(PrismaticJointDef{.anchor = {2, 0}, .spring = spring, .restShift = 1}, discAt(3.5, 0)),
               WithinAbs(1, jointRounding));
    CHECK_THAT(energy(WheelJointDef{.anchor = {2, 0}, .axis = {1, 0}, .spring = spring}, discAt(1.5, 0)),
               WithinAbs(1, jointRounding));
    CHECK_THAT(energy(RevoluteJointDef{.anchor = {2, 0}, .spring = spring, .restAngle = 0.25}, discAt(2, 0, 0.75)),
               WithinAbs(1, jointRounding));
    CHECK_THAT(energy(WeldJointDef{.anchor = {2, 0}, .spring = spring, .bending = spring}, discAt(2, 0.5, 0.5)),
               WithinAbs(2, jointRounding));
    CHECK_THAT(energy(TargetJointDef{.anchor = {2, 0}, .target = {2, 1}, .spring = spring}, discAt(2, 0.5)),
               WithinAbs(1, jointRounding));
    CHECK(energy(DistanceJointDef{.anchorB = {2, 0}}, discAt(3, 0)) == 0);
}

TEST_CASE("a target without a spring has one of 5 Hz of the body's 2 kg", "[compare][metric]") {
    // k = 2 (10 pi)^2
    const TargetJointDef target{.anchor = {2, 0}, .target = {2, 0}};
    CHECK_THAT(energy(target, discAt(2, 1)), WithinAbs(std::pow(10 * 2 * quarter, 2), 1e-9));
}

}  // namespace plumb::compare
