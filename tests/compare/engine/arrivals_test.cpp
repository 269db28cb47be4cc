// SPDX-License-Identifier: MIT
#include <compare/engine/arrivals.h>

#include <cmath>

#include <compare/metric/metrics.h>

#include "catch.h"
#include "compare/engine/simulators.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

/// A floor, and two discs on a hinge that come after 0.5 s and again each 0.5 s.
Scene twoThatCome() {
    Scene scene{.name = "two_that_come", .question = "?", .duration = 2};
    scene.bodies.push_back({"floor", {.type = BodyType::Static, .shapes = {box({10, 1})}}});
    for (const char* name : {"a", "b"}) {
        SceneBody body{name, {.position = {name[0] == 'a' ? 0.0 : 1.0, 50}, .shapes = {circle(0.5)}}};
        body.appears = body.renewed = 0.5;
        scene.bodies.push_back(body);
    }
    scene.joints.push_back({"hinge", "a", "b", RevoluteJointDef{.anchor = {0.5, 50}}});
    return scene;
}

std::string complaint(const Scene& scene) {
    try {
        validate(scene);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a body that comes after half a second falls from then on, and from its place again, in every engine",
          "[compare][engine]") {
    const Scene scene = twoThatCome();
    CHECK(complaint(scene).empty());
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        const std::unique_ptr<Simulation> simulation = engine.build(scene);
        for (int step = 0; step < 120; ++step) {
            const int steps = step % 30;  // since it came, before this one
            const BodyState before = simulation->states()[1];
            CHECK(before.present == (step > 30));
            if (step <= 30) CHECK(before.position == Vec2(0, 50));
            simulation->step(scene.dt);
            const double fall = 9.81 / 2 * std::pow((steps + 1) / 60.0, 2);
            const double off = 9.81 / 2 / 60 * (steps + 1) / 60.0;  // of a first-order method
            if (step >= 30) CHECK_THAT(simulation->states()[2].position.y(), WithinAbs(50 - fall, off + 1e-6));
        }
    }
}

TEST_CASE("what comes while a scene runs is measured while it is there", "[compare][engine]") {
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        const Scene scene = twoThatCome();
        const Measured measured = measure(scene, observe(scene, engine), nullptr, nullptr);
        CHECK(measured.metrics.at("penetration_max") == 0.0);
        CHECK(measured.metrics.at("joint_error_max").value() < 1e-4);
        CHECK_FALSE(measured.metrics.at("energy_drift"));  // what comes brings energy
    }
}

TEST_CASE("what comes together with what stays is joined to it, and apart from others is refused", "[compare][scene]") {
    Scene scene = twoThatCome();
    scene.joints[0].bodyA = "floor";
    CHECK(complaint(scene).empty());
    scene.joints[0].bodyA = "a";
    scene.bodies[2].appears = 1;
    CHECK(complaint(scene).starts_with("joints[0].bodyB: \"b\" does not appear with \"a\""));
    scene = twoThatCome();
    scene.bodies[1].appears = -1;
    CHECK(complaint(scene).starts_with("bodies[1].appears: -1"));
    scene = twoThatCome();
    scene.bodies[1].renewed = 0.001;
    CHECK(complaint(scene).starts_with("bodies[1].renewed: 0.001 is shorter than a step"));
    scene = twoThatCome();
    scene.probes.push_back({.name = "height", .quantity = PositionProbe{"a"}});
    CHECK(complaint(scene).starts_with("probes: there are some"));
    scene = twoThatCome();
    scene.wrap.width = 20;
    CHECK(complaint(scene).starts_with("wrap: wanted none"));
    scene = twoThatCome();
    scene.bodies[1].def.type = BodyType::Kinematic;
    scene.movers.push_back({"m", "a", SwingMotion{}});
    CHECK(complaint(scene).starts_with("movers: \"a\" appears later"));
}

TEST_CASE("a swinging body is at amplitude times sin(rate t) in every engine", "[compare][movers]") {
    Scene scene{.name = "swing", .question = "?", .duration = 3};
    scene.bodies.push_back({"pusher", {.type = BodyType::Kinematic, .position = {1, 2}, .shapes = {box({1, 1})}}});
    scene.movers.push_back({"sway", "pusher", SwingMotion{.amplitude = {3, -1}, .rate = 2}});
    CHECK(complaint(scene).empty());
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        const std::unique_ptr<Simulation> simulation = engine.build(scene);
        for (int step = 1; step <= 180; ++step) {
            simulation->step(scene.dt);
            const Vec2 wanted = Vec2(1, 2) + Vec2(3, -1) * std::sin(2 * step / 60.0);
            CHECK((simulation->states()[0].position - wanted).norm() < 1e-5);
        }
    }
    scene.movers[0].motion = SwingMotion{.amplitude = {1, 0}, .rate = 0};
    CHECK(complaint(scene).starts_with("movers[0].swing.rate: 0"));
}

}  // namespace plumb::compare
