// SPDX-License-Identifier: MIT
// Do joints do in each engine what the scene says, where the engine has them?
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <compare/engine/engine.h>
#include <compare/engine/plumb_world.h>
#include <compare/metric/joint_state.h>
#include <compare/metric/observation.h>
#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/engine/simulators.h"
#include "numbers.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

SceneBody ball(const std::string& name, const Vec2& position, double mass, double inertia = 1) {
    SceneBody body{name, {.position = position, .canSleep = false, .shapes = {circle(0.2)}}};
    body.def.mass = Mass{mass, {0, 0}, inertia};
    return body;
}

/// A post at the origin and a ball of 2 kg and 0.5 kg m^2 at (1, 0), without gravity.
Scene postAndBall(const JointDef& def, double duration = 1) {
    return {.name = "post_and_ball",
            .gravity = {0, 0},
            .duration = duration,
            .bodies = {{"post", {.type = BodyType::Static}}, ball("ball", {1, 0}, 2, 0.5)},
            .joints = {{"joint", "post", "ball", def}}};
}

/// The engines of this build that can build the scene; those that cannot must be the ones that are named.
std::vector<Observation> runs(const Scene& scene, const std::set<std::string>& unsupporting = {}) {
    std::vector<Observation> result;
    for (const Engine& engine : simulators()) {
        Observation seen = observe(scene, engine);
        INFO(engine.name << ": " << seen.unsupported);
        CHECK(seen.unsupported.empty() == !unsupporting.contains(engine.name));
        if (seen.unsupported.empty()) result.push_back(std::move(seen));
    }
    return result;
}

const BodyState& last(const Observation& seen, std::size_t body = 1) {
    return seen.states.back().at(body);
}

/// When a quantity first passes zero, between two ticks.
double firstZero(const Observation& seen, const std::function<double(const std::vector<BodyState>&)>& quantity) {
    for (std::size_t tick = 1; tick < seen.states.size(); ++tick) {
        const double before = quantity(seen.states[tick - 1]), now = quantity(seen.states[tick]);
        if (before * now <= 0 && before != now) return seen.dt * (static_cast<double>(tick) - now / (now - before));
    }
    return 1e9;
}

double xOf(const std::vector<BodyState>& states) {
    return states[1].position.x();
}

// Engines whose springs are stable by damping take up to 4 % longer at these rates, 10 rad/s at 60 steps a second.
constexpr double springs = 0.04;

/// Chipmunk moves bodies first and accelerates them then: what starts at rest is half a step late, and what starts in
/// the middle has its turn so much earlier [s].
double lag(const Observation& seen) {
    return seen.engine == "chipmunk" ? seen.dt / 2 : 0;
}

}  // namespace

TEST_CASE("2 kg on a spring of 200 N/m pass its middle after a quarter of 2 pi / 10 s in each engine",
          "[compare][engine]") {
    const Spring spring{200, 0};
    const DistanceJointDef rod{.anchorA = {-1, 0}, .anchorB = {1, 0}, .length = 1.9, .spring = spring};
    for (const Observation& seen : runs(postAndBall(rod)))
        CHECK_THAT(firstZero(seen, [](const auto& s) { return xOf(s) - 0.9; }),
                   WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    const PrismaticJointDef slide{.anchor = {1, 0}, .spring = spring, .restShift = -0.1};
    for (const Observation& seen : runs(postAndBall(slide), {"box2d-2.4"}))
        CHECK_THAT(firstZero(seen, [](const auto& s) { return xOf(s) - 0.9; }),
                   WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    const WheelJointDef wheel{.anchor = {1, 0}, .axis = {1, 0}, .spring = spring, .restShift = -0.1};
    for (const Observation& seen : runs(postAndBall(wheel)))
        CHECK_THAT(firstZero(seen, [](const auto& s) { return xOf(s) - 0.9; }),
                   WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
}

TEST_CASE("two balls of 2 kg on a spring of 100 N/m swing as 1 kg does", "[compare][engine]") {
    Scene scene =
        postAndBall(DistanceJointDef{.anchorA = {0, 0}, .anchorB = {1, 0}, .length = 0.8, .spring = Spring{100, 0}});
    scene.bodies[0] = ball("post", {0, 0}, 2);
    for (const Observation& seen : runs(scene)) {
        const auto stretch = [](const auto& s) { return s[1].position.x() - s[0].position.x() - 0.8; };
        CHECK_THAT(firstZero(seen, stretch), WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    }
}

TEST_CASE("a spring at the end of a lever swings the mass that it moves there", "[compare][engine]") {
    // Hung at its rim, 0.5 m from its centre, across the pull: 1 / m = 1/2 + 0.5^2 / 0.5 = 1 per kg.
    const DistanceJointDef spring{.anchorA = {-5, 0.5}, .anchorB = {1, 0.5}, .length = 5.98, .spring = Spring{100, 0}};
    for (const Observation& seen : runs(postAndBall(spring))) {
        const auto anchor = [](const auto& s) { return s[1].position.x() - 0.5 * std::sin(s[1].angle) - 0.98; };
        CHECK_THAT(firstZero(seen, anchor), WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    }
}

TEST_CASE("0.5 kg m^2 on a spring of 50 N m turn back to its rest angle after a quarter of 2 pi / 10 s",
          "[compare][engine]") {
    const auto angle = [](const auto& s) { return s[1].angle - 0.2; };
    const RevoluteJointDef hinge{.anchor = {1, 0}, .spring = Spring{50, 0}, .restAngle = 0.2};
    for (const Observation& seen : runs(postAndBall(hinge), {"box2d-2.4"}))
        CHECK_THAT(firstZero(seen, angle), WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    Scene weld = postAndBall(WeldJointDef{.anchor = {1, 0}, .bending = Spring{50, 0}});
    weld.bodies[1].def.angularVelocity = 1;
    for (const Observation& seen : runs(weld)) {
        // It starts in the middle: over the first half of a period it is turned one way.
        const auto from = [](const auto& s) { return s[1].angularVelocity; };
        CHECK_THAT(firstZero(seen, from), WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    }
}

TEST_CASE("a damper of 4 N s/m slows 2 kg to 1 / e in half a second", "[compare][engine]") {
    Scene scene = postAndBall(PrismaticJointDef{.anchor = {1, 0}, .spring = Spring{0, 4}}, 0.5);
    scene.bodies[1].def.velocity = {3, 0};
    for (const Observation& seen : runs(scene, {"box2d-2.4"}))
        CHECK_THAT(last(seen).velocity.x(), WithinAbs(3 / std::exp(1), 0.02));
}

TEST_CASE("a slide stops at its limit, a hinge at its angle, a rope at its length", "[compare][engine]") {
    Scene slide = postAndBall(PrismaticJointDef{.anchor = {1, 0}, .limit = Limit{-0.2, 0.5}});
    slide.bodies[1].def.velocity = {2, 0};
    Scene hinge = postAndBall(RevoluteJointDef{.anchor = {1, 0}, .limit = Limit{-1, 0.5}});
    hinge.bodies[1].def.angle = 1;
    hinge.bodies[1].def.angularVelocity = 2;
    Scene wheel = postAndBall(WheelJointDef{.anchor = {1, 0}, .axis = {1, 0}, .limit = Limit{-0.2, 0.5}});
    wheel.bodies[1].def.velocity = {2, 0};
    Scene rope =
        postAndBall(DistanceJointDef{.anchorA = {0, 0}, .anchorB = {1, 0}, .spring = Spring{}, .maxLength = 1.5});
    rope.bodies[1].def.velocity = {2, 0};
    constexpr double give = 0.01;
    for (const Observation& seen : runs(slide)) CHECK(last(seen).position.x() < 1.5 + give);
    for (const Observation& seen : runs(wheel)) CHECK(last(seen).position.x() < 1.5 + give);
    for (const Observation& seen : runs(rope)) CHECK(last(seen).position.x() < 1.5 + give);
    for (const Observation& seen : runs(hinge)) CHECK(last(seen).angle < 1.5 + give);
}

TEST_CASE("a motor of 4 N pushes 2 kg along its axis by 1 m in a second", "[compare][engine]") {
    const PrismaticJointDef slide{.anchor = {1, 0}, .axis = {0, -3}, .motorSpeed = 100, .maxMotorForce = 4};
    for (const Observation& seen : runs(postAndBall(slide), {"chipmunk"})) {
        CHECK_THAT(last(seen).position.y(), WithinAbs(-1, 0.02));  // semi-implicit: v dt / 2
        CHECK_THAT(last(seen).position.x(), WithinAbs(1, 1e-5));
        CHECK_THAT(last(seen).angle, WithinAbs(0, 1e-5));
    }
}

TEST_CASE("3 kg beside 2 kg on a pulley fall at 1.962 m/s^2, and with a ratio of 2 one goes twice as far",
          "[compare][engine]") {
    Scene scene =
        postAndBall(PulleyJointDef{.groundA = {-1, 4}, .groundB = {1, 4}, .anchorA = {-1, 0}, .anchorB = {1, 0}});
    scene.gravity = {0, -9.81};
    scene.bodies = {ball("post", {-1, 0}, 2), ball("ball", {1, 0}, 3)};
    for (const Observation& seen : runs(scene, {"box2d-3", "chipmunk"}))
        CHECK_THAT(last(seen).velocity.y(), WithinAbs(-1.962, 1e-3));
    std::get<PulleyJointDef>(scene.joints[0].def).ratio = 2;
    for (const Observation& seen : runs(scene, {"box2d-3", "chipmunk"}))
        CHECK_THAT(last(seen, 0).position.y(), WithinAbs(-2 * last(seen).position.y(), 1e-3));
}

TEST_CASE("a wheel geared by 2 to another turns it half as far the other way", "[compare][engine]") {
    Scene scene = postAndBall(RevoluteJointDef{.anchor = {1, 0}});
    scene.bodies[1].def.angularVelocity = 3;
    scene.bodies.push_back(ball("other", {3, 0}, 2, 2));
    scene.joints.push_back({"axle", "post", "other", RevoluteJointDef{.anchor = {3, 0}}});
    scene.joints.push_back({.name = "gear", .def = GearJointDef{.ratio = 2}, .jointA = "joint", .jointB = "axle"});
    for (const Observation& seen : runs(scene, {"box2d-3"})) {
        CHECK_THAT(last(seen).angularVelocity, WithinAbs(-2 * last(seen, 2).angularVelocity, 1e-3));
        CHECK_THAT(last(seen).angularVelocity, WithinAbs(1.5, 1e-2));  // 0.5 * 3 / (0.5 + 2 / 4)
    }
}

TEST_CASE("a motor joint takes back half of its error in ln 2 / 5 s, or no more than its force can",
          "[compare][engine]") {
    MotorJointDef hold{.offset = Vec2(2, 0), .rate = 5, .maxForce = 1e6, .maxTorque = 1e6};
    for (const Observation& seen : runs(postAndBall(hold, 0.5))) {
        const double left = 2 - last(seen).position.x();
        CHECK_THAT(left, WithinAbs(std::exp(-2.5), 0.02));  // of 1 m; each step its share, a little late
    }
    hold.maxForce = 1;
    for (const Observation& seen : runs(postAndBall(hold, 0.5)))
        CHECK_THAT(last(seen).position.x(), WithinAbs(1 + 0.0625, 5e-3));  // 0.5 m/s^2
    const MotorJointDef friction{.rate = 0, .maxForce = 1, .maxTorque = 0};
    Scene sliding = postAndBall(friction);
    sliding.bodies[1].def.velocity = {3, 0};
    for (const Observation& seen : runs(sliding)) CHECK_THAT(last(seen).velocity.x(), WithinAbs(2.5, 1e-3));
}

TEST_CASE("a target of 200 N/m pulls 2 kg to it in a quarter of 2 pi / 10 s", "[compare][engine]") {
    Scene scene = postAndBall(FilterJointDef{});
    scene.joints = {{"drag", "ball", "",
                     TargetJointDef{.anchor = {1, 0}, .target = {1, 1}, .spring = Spring{200, 0}, .maxForce = 1e4}}};
    for (const Observation& seen : runs(scene, {"chipmunk"}))
        CHECK_THAT(firstZero(seen, [](const auto& s) { return s[1].position.y() - 1; }),
                   WithinAbs(test::pi / 20, springs * test::pi / 20 + lag(seen)));
    std::get<TargetJointDef>(scene.joints[0].def).maxForce = 2;
    scene.duration = 0.5;
    for (const Observation& seen : runs(scene, {"chipmunk"}))
        CHECK_THAT(last(seen).position.y(), WithinAbs(0.125, 5e-3));
}

TEST_CASE("two balls that a filter joins pass through each other, as if it were not there", "[compare][engine]") {
    Scene scene = postAndBall(FilterJointDef{});
    scene.bodies[0] = ball("post", {-1, 0}, 2);
    scene.bodies[0].def.velocity = {4, 0};
    for (const Observation& seen : runs(scene)) {
        INFO(seen.engine);
        CHECK_THAT(last(seen, 0).position.x(), WithinAbs(3, 1e-5));
        CHECK_THAT(last(seen).position.x(), WithinAbs(1, 1e-5));
    }
    scene.joints.clear();
    for (const Observation& seen : runs(scene)) CHECK(last(seen).position.x() > 1.1);
}

TEST_CASE("a hinge that bears 15 N holds 1 kg and lets go of 2 kg, and says so", "[compare][engine]") {
    for (const double mass : {1.0, 2.0}) {
        Scene scene = postAndBall(RevoluteJointDef{.anchor = {1, 0}, .breaking = {.force = 15}});
        scene.gravity = {0, -9.81};
        scene.bodies[1] = ball("ball", {1, 0}, mass);
        for (const Observation& seen : runs(scene)) {
            INFO(seen.engine);
            CHECK((last(seen).position.y() < -4) == (mass == 2));
            CHECK(brokenBy(seen, 60) == Broken{mass == 2});
            CHECK(brokenBy(seen, 0) == Broken{false});
        }
    }
}

TEST_CASE("where Box2D has no such joint it says so", "[compare][engine]") {
    const auto complaint = [](const Scene& scene, const Engine& engine) { return observe(scene, engine).unsupported; };
    for (const Engine& engine : simulators()) {
        if (engine.name == "box2d-2.4") {
            CHECK(complaint(postAndBall(WeldJointDef{.spring = Spring{1, 0}}), engine) ==
                  "joint joint: Box2D 2.4 has no weld whose anchor gives");
            CHECK(complaint(postAndBall(MotorJointDef{.velocity = {1, 0}}), engine) ==
                  "joint joint: Box2D 2.4 has no motor joint that moves at a velocity");
            CHECK(complaint(postAndBall(DistanceJointDef{.anchorB = {1, 0}, .spring = Spring{}, .maxMotorForce = 1}),
                            engine) == "joint joint: Box2D 2.4 has no motor between two points");
        }
        if (engine.name == "box2d-3") {
            CHECK(complaint(postAndBall(MotorJointDef{.velocity = {1, 0}}), engine) ==
                  "joint joint: Box2D 3 has no motor joint that holds a pose and moves at a velocity");
            CHECK(complaint(postAndBall(RevoluteJointDef{.limit = Limit{-4, 4}}), engine) ==
                  "joint joint: Box2D 3 has no limit of an angle beyond 3.110");
        }
    }
}

TEST_CASE("a sensor counts what flies into it, each time, and touches nothing", "[compare][engine]") {
    Scene scene = postAndBall(FilterJointDef{});
    scene.joints.clear();
    ShapeDef room = box({0.5, 0.5});
    room.sensor = true;
    scene.bodies[0].def.shapes = {room};
    scene.bodies[1].def.position = {-3, 0};
    scene.bodies[1].def.velocity = {6, 0};
    scene.probes = {{.name = "count", .quantity = SensorCountProbe{"post"}}};
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        const Observation seen = observe(scene, engine);
        CHECK(seen.probes.front().at(0) == 0);
        CHECK(seen.probes.back().at(0) == 1);
        CHECK_THAT(last(seen).position.x(), WithinAbs(3, 1e-5));
    }
}

TEST_CASE("Plumb's joints say of themselves what is measured of them, in every built-in scene", "[compare][engine]") {
    for (const Scene& scene : builtinScenes()) {
        if (scene.joints.empty()) continue;
        PlumbWorld made = plumbWorld(scene);
        const JointStates joints(scene);
        for (int step = 0; step < 20; ++step) made.world.step(scene.dt);
        std::vector<BodyState> states;
        for (const BodyId id : made.bodies) {
            const Body body = made.world.body(id);
            states.push_back({body.position(), body.angle(), {}, 0});
        }
        for (std::size_t i = 0; i < made.joints.size(); ++i) {
            INFO(scene.name << ", " << scene.joints[i].name);
            REQUIRE(made.world.contains(made.joints[i]));
            CHECK_THAT(made.world.joint(made.joints[i]).error(), WithinAbs(joints.gap(i, states), 1e-6));
        }
    }
}

}  // namespace plumb::compare
