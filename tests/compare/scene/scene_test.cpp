// SPDX-License-Identifier: MIT
#include <compare/scene/scene.h>

#include <functional>
#include <numbers>

#include <compare/scene/builtin.h>

#include "catch.h"
#include "numbers.h"

namespace plumb::compare {
namespace {

/// Something of everything, and valid.
Scene validScene() {
    return {
        .name = "valid_1",
        .bodies = {{"ground", {.type = BodyType::Static}}, {"ball", {.shapes = {circle(0.5)}}}},
        .joints = {{"hinge", "ground", "ball", RevoluteJointDef{}},
                   {"rod", "ground", "ball", DistanceJointDef{.anchorB = {0, 1}}}},
        .closedForm = ClosedForm{.bodies = {PiecewiseMotion{"ball", {{}, {.start = 1}}}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"ball"}},
                   {.name = "press", .quantity = NormalForceProbe{"ground", "ball"}},
                   {.name = "pull", .quantity = JointForceProbe{"rod"}}},
        .checks = {ExactCheck{}, AgreeCheck{}, InvariantCheck{.metric = "probe.pull"}, OrderCheck{}},
    };
}

/// What validate says of the scene after a change; "valid" when it says nothing.
std::string sceneComplaint(const std::function<void(Scene&)>& change) {
    Scene scene = validScene();
    change(scene);
    try {
        validate(scene);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "valid";
}

template <class T>
T& motionOf(Scene& scene) {
    return scene.closedForm->bodies.at(0).emplace<T>();
}

}  // namespace

TEST_CASE("2 s at 60 Hz are 120 steps, and 0.1 s at 30 Hz are 3", "[compare][scene]") {
    CHECK(stepCount({.duration = 2, .dt = 1.0 / 60}) == 120);
    CHECK(stepCount({.duration = 0.1, .dt = 1.0 / 30}) == 3);
    CHECK(stepCount({.duration = 1, .dt = 0.3}) == 3);
}

TEST_CASE("a scene bounces when the restitution of any of its shapes is over 0", "[compare][scene]") {
    Scene scene = validScene();
    CHECK_FALSE(bounces(scene));
    scene.bodies[1].def.shapes[0].material.restitution = 0.01;
    CHECK(bounces(scene));
}

TEST_CASE("a scene with something of everything is valid", "[compare][scene]") {
    CHECK(sceneComplaint([](Scene&) {}) == "valid");
}

TEST_CASE("names that are empty, malformed, used twice or unknown are refused", "[compare][scene][errors]") {
    CHECK(sceneComplaint([](Scene& s) { s.name = ""; }) ==
          "name: \"\" is not a name of small letters, digits and underscores");
    CHECK(sceneComplaint([](Scene& s) { s.name = "../etc"; }) ==
          "name: \"../etc\" is not a name of small letters, digits and underscores");
    CHECK(sceneComplaint([](Scene& s) { s.bodies[1].name = ""; }) == "bodies[1].name: \"\" is empty, wanted a name");
    CHECK(sceneComplaint([](Scene& s) { s.bodies[1].name = "ground"; }) ==
          "bodies[1].name: \"ground\" is used twice, wanted a name that differs from bodies[0]");
    CHECK(sceneComplaint([](Scene& s) { s.joints[1].name = "hinge"; }) ==
          "joints[1].name: \"hinge\" is used twice, wanted a name that differs from joints[0]");
    CHECK(sceneComplaint([](Scene& s) { s.probes[1].name = "angle"; }) ==
          "probes[1].name: \"angle\" is used twice, wanted a name that differs from probes[0]");
    CHECK(sceneComplaint([](Scene& s) { s.joints[0].bodyA = "grund"; }) ==
          "joints[0].bodyA: \"grund\" is not the name of a body, the nearest is ground; known are ground, ball");
    CHECK(sceneComplaint([](Scene& s) { s.joints[0].bodyA.clear(); }) ==
          "joints[0].bodyA: is not given, wanted the name of a body; known are ground, ball");
    CHECK(sceneComplaint([](Scene& s) { s.joints[0].bodyA = "ball"; }) ==
          "joints[0].bodyB: \"ball\" is bodyA too, wanted another body");
    CHECK(sceneComplaint([](Scene& s) { s.probes[0].quantity = AngleProbe{"bal"}; }) ==
          "probes[0].angle.body: \"bal\" is not the name of a body, the nearest is ball; known are ground, ball");
    CHECK(sceneComplaint([](Scene& s) {
              s.probes[1].quantity = NormalForceProbe{"ball", "ball"};
          }) == "probes[1].normalForce.bodyB: \"ball\" is bodyA too, wanted another body");
    CHECK(sceneComplaint([](Scene& s) { s.joints.clear(); }) ==
          "probes[2].jointForce.joint: \"rod\" is not the name of a joint, there is none");
    CHECK(sceneComplaint([](Scene& s) { motionOf<PiecewiseMotion>(s).body = "x"; }) ==
          "closedForm.bodies[0].piecewise.body: \"x\" is not the name of a body, the nearest is ball; known are "
          "ground, ball");
    CHECK(sceneComplaint([](Scene& s) { s.closedForm->bodies.push_back(PendulumMotion{.body = "ball"}); }) ==
          "closedForm.bodies[1].pendulum.body: \"ball\" has a motion already, wanted one for each body");
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<SwingsMotion>(s) = {"ball", "x"};
          }).starts_with("closedForm.bodies[0].swings.joint: \"x\" is not the name of a joint"));
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<FreeMotion>(s) = {"ball", 0};
          }).starts_with("closedForm.bodies[0].free.shortestFlight: 0 is not positive"));
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<CaughtMotion>(s) = {"ball", "ground", "ground"};
          }) == "closedForm.bodies[0].caught.body: \"ball\" is neither bullet nor block, wanted one of them");
}

TEST_CASE("impossible times, bodies and joints are refused", "[compare][scene][errors]") {
    CHECK(sceneComplaint([](Scene& s) { s.gravity.x() = test::nan; }) == "gravity: (nan, -9.81) is not finite");
    CHECK(sceneComplaint([](Scene& s) { s.duration = 0; }) == "duration: 0 is not positive");
    CHECK(sceneComplaint([](Scene& s) { s.dt = -0.1; }) == "dt: -0.1 is not positive");
    CHECK(sceneComplaint([](Scene& s) { s.dt = 1e-300; }) == "dt: 1e-300 makes more than 10 million steps of 2 s");
    CHECK(sceneComplaint([](Scene& s) { s.dt = 5; }) == "dt: 5 is longer than the duration of 2 s");
    CHECK(sceneComplaint([](Scene& s) { s.bodies.clear(); }) == "bodies: there is none, wanted at least one");
    CHECK(sceneComplaint([](Scene& s) { s.bodies[1].def.shapes[0] = circle(-1); }) ==
          "bodies[1].shapes[0].circle.radius: -1 is not positive");
    CHECK(sceneComplaint([](Scene& s) { s.bodies[1].def.position.x() = test::nan; }) ==
          "bodies[1].position: (nan, 0) is not finite");
    CHECK(sceneComplaint([](Scene& s) {
              s.joints[0].def = RevoluteJointDef{.anchor = {test::nan, 0}};
          }) == "joints[0].revolute.anchor: (nan, 0) is not finite");
    CHECK(sceneComplaint([](Scene& s) { s.joints[1].def = DistanceJointDef{.length = -2}; }) ==
          "joints[1].distance.length: -2 is not positive");
    CHECK(sceneComplaint([](Scene& s) { s.joints[1].def = DistanceJointDef{}; }) ==
          "joints[1].distance.anchorB: (0, 0) is anchorA too, wanted another point or a length");
}

TEST_CASE("impossible closed forms are refused", "[compare][scene][errors]") {
    const std::string at = "closedForm.bodies[0].";
    CHECK(sceneComplaint([](Scene& s) { s.closedForm->until = -1; }) == "closedForm.until: -1 is negative");
    CHECK(sceneComplaint([](Scene& s) { s.closedForm->bodies.clear(); }) ==
          "closedForm.bodies: there is none, wanted at least one");
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<PiecewiseMotion>(s) = {"ball", {}};
          }) == at + "piecewise.flights: there is none, wanted at least one");
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<PiecewiseMotion>(s) = {"ball", {{.start = 1}}};
          }) == at + "piecewise.flights[0].start: 1 is not 0: the first flight starts with the scene");
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<PiecewiseMotion>(s) = {"ball", {{}, {.start = 2}, {.start = 1}}};
          }) == at + "piecewise.flights[2].start: 1 is before the flight before it");
    CHECK(sceneComplaint([](Scene& s) { motionOf<DampedFlight>(s) = {.body = "ball"}; }) ==
          at + "damped.damping: 0 is not positive");
    CHECK(sceneComplaint([](Scene& s) { motionOf<PendulumMotion>(s) = {.body = "ball", .equivalentLength = 0}; }) ==
          at + "pendulum.equivalentLength: 0 is not positive");
    CHECK(sceneComplaint([](Scene& s) {
              motionOf<PendulumMotion>(s) = {.body = "ball", .amplitude = std::numbers::pi};
          }) == at + "pendulum.amplitude: 3.141592653589793 is not between -pi and pi");
}

TEST_CASE("checks of metrics and limits that do not exist are refused", "[compare][scene][errors]") {
    const auto withCheck = [](const Check& check) { return sceneComplaint([&](Scene& s) { s.checks = {check}; }); };
    CHECK(
        withCheck(InvariantCheck{.metric = "energy_drfit"})
            .starts_with("checks[0].invariant.metric: \"energy_drfit\" is not the name of a metric of this scene, the "
                         "nearest is energy_drift; known are divergence_max, "));
    CHECK(withCheck(InvariantCheck{.metric = "energy_drift", .limit = -1}) ==
          "checks[0].invariant.limit: -1 is negative");
    CHECK(withCheck(ExactCheck{.limit = test::nan}) == "checks[0].exact.limit: nan is not finite");
    CHECK(withCheck(AgreeCheck{.tolerance = 0}) == "checks[0].agree.tolerance: 0 is not positive");
    CHECK(sceneComplaint([](Scene& s) { s.closedForm.reset(); }) ==
          "checks[0].exact: the scene has no closed form to be exact to");
    CHECK(sceneComplaint([](Scene& s) {
              s.closedForm.reset();
              s.checks = {InvariantCheck{.metric = "error_max"}};
          }).starts_with("checks[0].invariant.metric: \"error_max\" is not the name of a metric of this scene"));
}

}  // namespace plumb::compare
