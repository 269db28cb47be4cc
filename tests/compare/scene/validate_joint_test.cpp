// SPDX-License-Identifier: MIT
#include <compare/scene/validate/parts.h>

#include <functional>
#include <limits>

#include "catch.h"
#include "numbers.h"

namespace plumb::compare {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A hinge, a slide and a gear between them; then the joint that is asked about.
Scene sceneWith(const SceneJoint& joint) {
    return {.name = "valid",
            .bodies = {{"ground", {.type = BodyType::Static}}, {"ball", {.shapes = {circle(0.5)}}}},
            .joints = {{"hinge", "ground", "ball", RevoluteJointDef{}},
                       {"slide", "ground", "ball", PrismaticJointDef{}},
                       {.name = "gear", .def = GearJointDef{}, .jointA = "hinge", .jointB = "slide"},
                       joint}};
}

std::string jointComplaint(const SceneJoint& joint) {
    try {
        validate(sceneWith(joint));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "valid";
}

std::string jointComplaint(const JointDef& def) {
    return jointComplaint(SceneJoint{"joint", "ground", "ball", def});
}

}  // namespace

TEST_CASE("one of each kind of joint is valid, and what may be infinite is", "[compare][scene]") {
    CHECK(jointComplaint(RevoluteJointDef{.limit = Limit{-infinite, 0}, .maxMotorTorque = infinite}) == "valid");
    CHECK(jointComplaint(PrismaticJointDef{.limit = Limit{0, infinite}, .maxMotorForce = infinite}) == "valid");
    CHECK(jointComplaint(DistanceJointDef{.length = 1, .spring = Spring{}, .maxLength = 1}) == "valid");
    CHECK(jointComplaint(WeldJointDef{.spring = Spring{1, 2}}) == "valid");
    CHECK(jointComplaint(WheelJointDef{.breaking = {.force = 5}}) == "valid");
    CHECK(jointComplaint(PulleyJointDef{.groundA = {0, 2}, .groundB = {1, 2}}) == "valid");
    CHECK(jointComplaint(MotorJointDef{.maxForce = infinite, .maxTorque = infinite}) == "valid");
    CHECK(jointComplaint(SceneJoint{"joint", "ball", "", TargetJointDef{}}) == "valid");
    CHECK(jointComplaint(FilterJointDef{}) == "valid");
}

TEST_CASE("an impossible number in a joint is refused by its field", "[compare][scene][errors]") {
    const std::string at = "joints[3].";
    CHECK(jointComplaint(RevoluteJointDef{.limit = Limit{1, -1}}) ==
          at + "revolute.limit.lower: 1 is more than limit.upper -1");
    CHECK(jointComplaint(RevoluteJointDef{.limit = Limit{test::nan, 0}}) ==
          at + "revolute.limit.lower: nan is not finite");
    CHECK(jointComplaint(RevoluteJointDef{.maxMotorTorque = -1}) == at + "revolute.maxMotorTorque: -1 is negative");
    CHECK(jointComplaint(RevoluteJointDef{.restAngle = infinite}) == at + "revolute.restAngle: inf is not finite");
    CHECK(jointComplaint(RevoluteJointDef{.spring = Spring{-1, 0}}) ==
          at + "revolute.spring.stiffness: -1 is negative");
    CHECK(jointComplaint(PrismaticJointDef{.axis = {0, 0}}) == at + "prismatic.axis: (0, 0) has no direction");
    CHECK(jointComplaint(PrismaticJointDef{.maxMotorForce = test::nan}) ==
          at + "prismatic.maxMotorForce: nan is not finite");
    CHECK(jointComplaint(DistanceJointDef{.anchorB = {0, 1}, .minLength = 2, .maxLength = 1}) ==
          at + "distance.maxLength: 1 is less than minLength 2");
    CHECK(jointComplaint(WeldJointDef{.bending = Spring{0, -2}}) == at + "weld.bending.damping: -2 is negative");
    CHECK(jointComplaint(WheelJointDef{.axis = {test::nan, 0}}) == at + "wheel.axis: (nan, 0) is not finite");
    CHECK(jointComplaint(PulleyJointDef{.ratio = 0}) == at + "pulley.ratio: 0 is not positive");
    CHECK(jointComplaint(MotorJointDef{.rate = -1}) == at + "motor.rate: -1 is negative");
    CHECK(jointComplaint(SceneJoint{"joint", "ball", "", TargetJointDef{.maxForce = -1}}) ==
          at + "target.maxForce: -1 is negative");
    CHECK(jointComplaint(WheelJointDef{.breaking = {.torque = 0}}) == at + "wheel.breaking.torque: 0 is not positive");
}

TEST_CASE("a gear couples two joints that stand before it and turn or slide", "[compare][scene][errors]") {
    const auto gear = [](const std::string& a, const std::string& b, double ratio = 1) {
        return jointComplaint(
            SceneJoint{.name = "joint", .def = GearJointDef{.ratio = ratio}, .jointA = a, .jointB = b});
    };
    CHECK(gear("hinge", "slide") == "valid");
    CHECK(gear("hinge", "hinge") == "joints[3].jointB: \"hinge\" is jointA too, wanted another joint");
    CHECK(gear("hinge", "slid") ==
          "joints[3].jointB: \"slid\" is not the name of a joint before it, the nearest is slide; known are hinge, "
          "slide, gear");
    CHECK(gear("joint", "slide").starts_with("joints[3].jointA: \"joint\" is not the name of a joint before it"));
    CHECK(gear("gear", "slide") == "joints[3].jointA: \"gear\" is neither revolute nor prismatic");
    CHECK(gear("hinge", "slide", 0) == "joints[3].gear.ratio: 0 would gear nothing");
    CHECK(jointComplaint(SceneJoint{"joint", "ball", "", GearJointDef{}, "hinge", "slide"}) ==
          "joints[3].bodyA: \"ball\" is one too many: a gear couples two joints");
}

TEST_CASE("a target has one body, and only gears name joints", "[compare][scene][errors]") {
    CHECK(jointComplaint(TargetJointDef{}) == "joints[3].bodyB: \"ball\" is one too many: a target has one body");
    CHECK(jointComplaint(SceneJoint{"joint", "ground", "ball", WeldJointDef{}, "hinge", ""}) ==
          "joints[3].jointA: \"hinge\" is one too many: only a gear couples joints");
    CHECK(jointComplaint(SceneJoint{"joint", "bal", "", TargetJointDef{}}) ==
          "joints[3].bodyA: \"bal\" is not the name of a body, the nearest is ball; known are ground, ball");
}

TEST_CASE("a shape's rule is code and cannot stand in a scene", "[compare][scene][errors]") {
    Scene scene = sceneWith({"joint", "ground", "ball", FilterJointDef{}});
    scene.bodies[1].def.shapes[0].rule = [](const ContactCandidate&) { return true; };
    CHECK_THROWS_WITH(validate(scene), "bodies[1].shapes[0].rule: is code, and a scene is data: wanted none");
}

}  // namespace plumb::compare
