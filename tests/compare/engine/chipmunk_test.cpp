// SPDX-License-Identifier: MIT
// Does Chipmunk get a scene's masses, materials, damping and gravity as they are, and say what it cannot have?
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <compare/engine/engine.h>

#include "catch.h"
#include "compare/engine/simulators.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

constexpr double g = 9.81;         // [m/s^2]
constexpr double rounding = 1e-9;  // Chipmunk computes in double precision

Engine chipmunk() {
    for (const Engine& engine : simulators())
        if (engine.name == "chipmunk") return engine;
    FAIL("there is no Chipmunk in this build");
    return {};
}

SceneBody leadDisc(const std::string& name, const Vec2& position, const Material& material = {}) {
    return {name, {.position = position, .shapes = {circle(0.5, material)}}};
}

/// One disc, free of forces, for two seconds.
Scene freeDisc() {
    return {.name = "free_disc", .gravity = {0, 0}, .bodies = {leadDisc("disc", {0, 0})}};
}

/// A box of 1 m by 1 m on a floor: it touches from the start.
Scene crateOnFloor(const Material& floor, const Material& box) {
    SceneBody crate{"crate", {.position = {0, 0.5}, .shapes = {plumb::box({0.5, 0.5}, box)}}};
    SceneBody ground{"floor", {.type = BodyType::Static, .shapes = {segment({-50, 0}, {50, 0}, floor)}}};
    return {.name = "crate_on_floor", .duration = 1, .sleeping = false, .bodies = {ground, crate}};
}

BodyState chipmunkEnd(const Scene& scene, std::size_t body) {
    const Observation seen = observe(scene, chipmunk());
    INFO(seen.unsupported);
    REQUIRE(seen.unsupported.empty());
    return seen.states.back().at(body);
}

std::string chipmunkRefusal(const std::function<void(Scene&)>& change) {
    Scene scene = crateOnFloor({}, {});
    change(scene);
    return observe(scene, chipmunk()).unsupported;
}

std::string refusedJoint(const JointDef& def) {
    return chipmunkRefusal([&](Scene& scene) { scene.joints = {{"joint", "floor", "crate", def}}; });
}

}  // namespace

TEST_CASE("Chipmunk's double precision follows the scene's gravity scale and its own rule of a fall",
          "[compare][engine]") {
    Scene scene = freeDisc();
    scene.gravity = {0, -g};
    for (const double scale : {1.0, 0.25, 0.0, -1.0}) {
        scene.bodies[0].def.gravityScale = scale;
        const BodyState end = chipmunkEnd(scene, 0);
        CHECK_THAT(end.velocity.y(), WithinAbs(-scale * g * 2, rounding));
        // Each step moves at the velocity from before it: n (n - 1) / 2 g dt^2, of n = 120 steps.
        CHECK_THAT(end.position.y(), WithinAbs(-scale * g * 120 * 119 / 2 / 3600, rounding));
    }
}

TEST_CASE("damping in Chipmunk takes exp(-k t) off the velocity, and another off the spin", "[compare][engine]") {
    Scene scene = freeDisc();
    BodyDef& def = scene.bodies[0].def;
    def.velocity = {3, -4};
    def.angularVelocity = 5;
    def.linearDamping = 0.5;
    def.angularDamping = 0.8;
    const BodyState end = chipmunkEnd(scene, 0);
    CHECK_THAT(end.velocity.norm(), WithinAbs(5 * std::exp(-1), rounding));
    CHECK_THAT(end.angularVelocity, WithinAbs(5 * std::exp(-1.6), rounding));
}

TEST_CASE("in Chipmunk 1 kg at 3 m/s and 2 kg at rest part at e = 1 with -1 m/s and 2 m/s, at e = 0.5 with 0 and 1.5",
          "[compare][engine]") {
    for (const double e : {1.0, 0.5}) {
        Scene scene = freeDisc();
        scene.bodies = {leadDisc("a", {0, 0}, {.restitution = e}), leadDisc("b", {2, 0}, {.restitution = 0.3})};
        scene.bodies[0].def.mass = Mass{1, {0, 0}, 1};
        scene.bodies[1].def.mass = Mass{2, {0, 0}, 1};
        scene.bodies[0].def.velocity = {3, 0};
        CHECK_THAT(chipmunkEnd(scene, 0).velocity.x(), WithinAbs(1 - 2 * e, rounding));
        CHECK_THAT(chipmunkEnd(scene, 1).velocity.x(), WithinAbs(1 + e, rounding));
    }
}

TEST_CASE("a body in Chipmunk weighs what its shapes or its own mass say, and turns about its own centre of mass",
          "[compare][engine]") {
    Scene scene = crateOnFloor({}, {.density = 3});
    scene.probes = {{.name = "weight", .quantity = NormalForceProbe{"crate", "floor"}, .unit = "N"}};
    const auto weight = [&scene] { return observe(scene, chipmunk()).probes.back().at(0); };
    CHECK_THAT(weight(), WithinRel(3 * g, 1e-3));
    scene.bodies[1].def.mass = Mass{5, {0.2, 0}, 0.4};
    CHECK_THAT(weight(), WithinRel(5 * g, 1e-3));

    // Hung 0.2 m beside its centre, it starts to fall with r m g / (I + m r^2).
    scene.joints = {{"hinge", "floor", "crate", RevoluteJointDef{.anchor = {0, 0.5}}}};
    scene.bodies[0].def.shapes.clear();
    scene.duration = scene.dt = 1e-3;
    scene.probes.clear();
    const double rate = chipmunkEnd(scene, 1).angularVelocity / 1e-3;
    CHECK_THAT(rate, WithinRel(-0.2 * 5 * g / (0.4 + 5 * 0.2 * 0.2), 1e-3));
}

TEST_CASE("friction in Chipmunk is mixed by the scene's rules, to the closed form of a slide", "[compare][engine]") {
    const std::vector<std::pair<Mix, double>> rules{
        {Mix::GeometricMean, 0.3}, {Mix::Average, 0.5}, {Mix::Minimum, 0.1}, {Mix::Maximum, 0.9}};
    for (const auto& [rule, friction] : rules) {
        INFO("friction " << friction);
        Scene scene = crateOnFloor({.friction = 0.9, .frictionMix = rule}, {.friction = 0.1, .frictionMix = rule});
        scene.bodies[1].def.velocity = {10, 0};
        // 1 % for the step or two in which the box settles, and for the tilt that friction below its centre gives it
        CHECK_THAT(chipmunkEnd(scene, 1).velocity.x(), WithinAbs(10 - friction * g, 0.1));
    }
}

TEST_CASE("Chipmunk mixes by itself where it can, and says in its settings when its user has to", "[compare][engine]") {
    const auto mixing = [](const Scene& scene) {
        for (const auto& [name, value] : chipmunk().settings(scene))
            if (name == "mixing of materials") return value;
        return std::string();
    };
    CHECK(mixing(crateOnFloor({.friction = 0.9}, {.friction = 0.1})).starts_with("its own"));
    CHECK(mixing(crateOnFloor({.restitution = 0.9}, {.restitution = 0.9})).starts_with("its own"));
    CHECK(mixing(crateOnFloor({.restitution = 0.9}, {})).starts_with("by the user"));
    CHECK(mixing(crateOnFloor({.surfaceSpeed = 1}, {})).starts_with("by the user"));
    CHECK(mixing(crateOnFloor({.frictionMix = Mix::Minimum}, {})).starts_with("by the user"));
}

TEST_CASE("categories beyond Chipmunk's 32 are kept apart all the same", "[compare][engine]") {
    for (const bool met : {true, false}) {
        Scene scene = crateOnFloor({}, {});
        scene.bodies[0].def.shapes[0].filter.category = std::uint64_t{1} << 40;
        if (!met) scene.bodies[1].def.shapes[0].filter.mask = ~(std::uint64_t{1} << 40);
        const double height = chipmunkEnd(scene, 1).position.y();
        CHECK((height > 0.45) == met);
    }
}

TEST_CASE("a slide's spring and its guide together bear in Chipmunk what the scene's joint bears",
          "[compare][engine]") {
    // A weight on a spring along a slope of 3 to 4: the spring takes 0.6 of it, the guide 0.8.
    Scene scene{.name = "slide", .duration = 8, .sleeping = false, .bodies = {{"post", {.type = BodyType::Static}}}};
    scene.bodies.push_back(leadDisc("weight", {0, 0}));
    scene.bodies[1].def.mass = Mass{2, {0, 0}, 0.5};
    scene.joints = {{"slide", "post", "weight", PrismaticJointDef{.axis = {0.8, 0.6}, .spring = Spring{100, 20}}}};
    scene.probes = {{.name = "force", .quantity = JointForceProbe{"slide"}, .unit = "N"}};
    const Observation seen = observe(scene, chipmunk());
    CHECK_THAT(seen.probes.back().at(0), WithinRel(2 * g, 1e-4));
    const double down = 0.6 * 2 * g / 100;
    CHECK((seen.states.back()[1].position + down * Vec2(0.8, 0.6)).norm() < 1e-4);
}

TEST_CASE("what Chipmunk cannot build it refuses by name", "[compare][engine]") {
    CHECK(chipmunkRefusal([](Scene&) {}).empty());
    CHECK(chipmunkRefusal([](Scene& scene) { scene.bodies[1].def.shapes[0].material.rollingResistance = 0.1; }) ==
          "body crate: Chipmunk has no rolling resistance");
    CHECK(chipmunkRefusal([](Scene& scene) { scene.bodies[0].def.shapes[0].oneWay = Vec2(0, 1); }) ==
          "body floor: Chipmunk leaves one-way shapes to its user's own code");
    CHECK(chipmunkRefusal([](Scene& scene) { scene.bodies[1].def.lockX = true; }) ==
          "body crate: Chipmunk has no lock along an axis");
    CHECK(refusedJoint(PulleyJointDef{}) == "joint joint: Chipmunk has no pulley");
    CHECK(refusedJoint(PrismaticJointDef{.motorSpeed = 1, .maxMotorForce = 1}) ==
          "joint joint: Chipmunk has no motor along a slide");
    CHECK(refusedJoint(DistanceJointDef{.anchorB = {1, 0}, .spring = Spring{}, .maxMotorForce = 1}) ==
          "joint joint: Chipmunk has no motor between two points");
    CHECK(refusedJoint(WeldJointDef{.spring = Spring{1, 0}}) == "joint joint: Chipmunk has no weld whose anchor gives");
    CHECK(refusedJoint(MotorJointDef{.velocity = {1, 0}}) ==
          "joint joint: Chipmunk has no motor joint that moves at a velocity");
}

}  // namespace plumb::compare
