// SPDX-License-Identifier: MIT
// Do the engines mean the same by every shape, material, filter and motor?
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <compare/engine/engine.h>

#include "catch.h"
#include "compare/engine/simulators.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

SceneBody body(const std::string& name, const ShapeDef& shape, const Vec2& position) {
    return {name, {.position = position, .shapes = {shape}}};
}

/// Level ground from 20 m to -20 m, to be stood on in an engine whose chains are solid on their right only.
ShapeDef ground(const Material& material = {}) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 40; ++i) points.push_back({20.0 - i, 0});
    return chain(points, material);
}

/// A floor, and one body a little over it.
Scene dropped(const ShapeDef& floor, const ShapeDef& shape, double height) {
    return {
        .name = "dropped",
        .duration = 1,
        .bodies = {{"floor", {.type = BodyType::Static, .shapes = {floor}}}, body("body", shape, {0, height + 0.01})},
        .probes = {{.name = "weight", .quantity = NormalForceProbe{"floor", "body"}, .unit = "N"}}};
}

BodyState endOf(const Scene& scene, const Engine& engine, std::size_t index) {
    return observe(scene, engine).states.back()[index];
}

std::string refusal(const Engine& engine, const Scene& scene) {
    try {
        engine.build(scene);
    } catch (const Unsupported& reason) {
        return reason.what();
    }
    return "none";
}

const Engine* box2d3() {
    for (const Engine& engine : engines())
        if (engine.name == "box2d-3") return &engine;
    return nullptr;
}

}  // namespace

TEST_CASE("every shape lies on a chain at its own height in each engine, and weighs what its area says",
          "[compare][engine]") {
    struct Case {
        ShapeDef shape;
        double height, area;
    };
    const double pi = std::numbers::pi;
    const std::vector<Case> cases{{circle(0.5), 0.5, pi / 4},
                                  {capsule({-0.5, 0}, {0.5, 0}, 0.3), 0.3, 0.6 + 0.09 * pi},
                                  {box({0.4, 0.3}), 0.3, 0.48},
                                  {roundedBox({0.4, 0.3}, 0.1), 0.4, 0.48 + 2.8 * 0.1 + 0.01 * pi}};
    for (const Case& c : cases) {
        const Scene scene = dropped(ground(), c.shape, c.height);
        for (const Engine& engine : simulators()) {
            INFO(engine.name << ", shape " << c.shape.shape.index());
            const Observation seen = observe(scene, engine);
            REQUIRE(seen.unsupported.empty());
            // Box2D 2.4 keeps polygons 2 cm apart, less 5 mm
            CHECK_THAT(seen.states.back()[1].position.y(), WithinAbs(c.height, 0.016));
            CHECK_THAT(seen.probes.back()[0], WithinAbs(9.81 * c.area, 0.005 * 9.81 * c.area));
        }
    }
}

TEST_CASE("a disc and a box in a ring of 36 segments stay inside in each engine", "[compare][engine]") {
    std::vector<Vec2> points;
    for (int i = 0; i < 36; ++i) {
        const double angle = -2 * std::numbers::pi * i / 36;  // clockwise: solid from inside
        points.push_back({3 * std::cos(angle), 3 * std::sin(angle)});
    }
    Scene scene{.name = "ring",
                .bodies = {{"ring", {.type = BodyType::Static, .shapes = {loop(points)}}},
                           body("disc", circle(0.4), {-2, 0}),
                           body("box", box({0.4, 0.4}), {2, 0})}};
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        for (const std::vector<BodyState>& row : observe(scene, engine).states)
            for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) CHECK(row[i].position.norm() < 2.7);
    }
}

TEST_CASE("a box on a belt of 1 m/s runs to +x with 1 m/s in each engine, whichever comes first", "[compare][engine]") {
    const Material belt{.surfaceSpeed = 1};
    for (const ShapeDef& floor : {ground(belt), ShapeDef{boxPolygon({20, 1}, {0, -1}), belt}}) {
        for (const bool beltFirst : {true, false}) {
            Scene scene = dropped(floor, box({0.5, 0.25}), 0.25);
            if (!beltFirst) std::swap(scene.bodies[0], scene.bodies[1]);
            for (const Engine& engine : simulators()) {
                INFO(engine.name << (beltFirst ? ", belt first" : ", box first"));
                // friction brings it to 1 m/s in 1 / (0.6 g) = 0.17 s
                CHECK_THAT(endOf(scene, engine, beltFirst ? 1 : 0).velocity.x(), WithinAbs(1, 0.01));
            }
        }
    }
}

TEST_CASE("friction 0.9 on 0.1 is 0.5, 0.3, 0.1, 0.09 or 0.9 as the rule says, and the later rule of two holds",
          "[compare][engine]") {
    const std::vector<std::pair<Mix, double>> rules{
        {Mix::Average, 0.5}, {Mix::GeometricMean, 0.3}, {Mix::Minimum, 0.1}, {Mix::Product, 0.09}, {Mix::Maximum, 0.9}};
    for (const auto& [rule, friction] : rules) {
        Scene scene = dropped(segment({-20, 0}, {20, 0}, {.friction = 0.9, .frictionMix = Mix::Average}),
                              box({0.5, 0.25}, {.friction = 0.1, .frictionMix = rule}), 0.25);
        scene.gravity = {9.81 * 0.5, -9.81 * std::sqrt(0.75)};  // the floor as a slope of 30 degrees
        const double slides = std::max(0.0, 9.81 * (0.5 - friction * std::sqrt(0.75)));  // [m/s^2]
        for (const Engine& engine : simulators()) {
            INFO(engine.name << ", friction " << friction);
            // the 1 cm that it falls first take 0.05 s of the second
            CHECK_THAT(endOf(scene, engine, 1).velocity.x(), WithinAbs(slides, 0.3));
        }
    }
}

TEST_CASE("restitution 0.8 on 0.2 bounces as 0.2 where the smaller holds, as 0.8 where the larger does",
          "[compare][engine]") {
    for (const Mix rule : {Mix::Minimum, Mix::Maximum}) {
        Scene scene = dropped(segment({-20, 0}, {20, 0}, {.restitution = 0.2, .restitutionMix = rule}),
                              circle(0.5, {.restitution = 0.8, .restitutionMix = Mix::Average}), 1.5);
        const double e = rule == Mix::Minimum ? 0.2 : 0.8;
        for (const Engine& engine : simulators()) {
            INFO(engine.name << ", e = " << e);
            double highest = 0;  // after the first impact
            for (const std::vector<BodyState>& row : observe(scene, engine).states)
                if (row[1].velocity.y() > 0) highest = std::max(highest, row[1].position.y());
            CHECK_THAT(highest, WithinAbs(0.5 + e * e, 0.1));  // a step's fall at 4.4 m/s is 7 cm
        }
    }
}

TEST_CASE("a group of -1 lets a box through the floor, one of 1 stops it against its masks", "[compare][engine]") {
    for (const int group : {-1, 1}) {
        Scene scene = dropped(ground(), box({0.5, 0.5}), 0.5);
        for (SceneBody& b : scene.bodies) {
            b.def.shapes[0].filter.group = group;
            if (group > 0) b.def.shapes[0].filter.mask = 0;
        }
        for (const Engine& engine : simulators()) {
            INFO(engine.name);
            const double height = endOf(scene, engine, 1).position.y();
            if (group < 0) CHECK(height < -3);
            if (group > 0) CHECK_THAT(height, WithinAbs(0.5, 0.02));
        }
    }
}

TEST_CASE("a body that starts asleep hangs in the air until another hits it", "[compare][engine]") {
    Scene scene{.name = "asleep",
                .bodies = {body("sleeper", box({0.5, 0.5}), {0, 10}), body("faller", box({0.25, 0.25}), {0, 14})}};
    scene.bodies[0].def.awake = false;
    for (const Engine& engine : simulators()) {
        INFO(engine.name);
        const Observation seen = observe(scene, engine);
        CHECK(seen.states[30][0].position.y() == 10);  // 0.8 s until the hit
        CHECK(seen.states.back()[0].position.y() < 9);
    }
}

TEST_CASE("a motor of 1 Nm brings a wheel of 0.5 kg m^2 to 2 rad/s in a second, one without bound to 5 rad/s at once",
          "[compare][engine]") {
    for (const double torque : {1.0, std::numeric_limits<double>::infinity()}) {
        Scene scene{.name = "motor", .duration = 1, .bodies = {{"axle", {.type = BodyType::Static}}}};
        SceneBody wheel = body("wheel", circle(0.5), {0, 2});
        wheel.def.mass = Mass{2, {0, 0}, 0.5};
        scene.bodies.push_back(wheel);
        scene.joints = {
            {"hinge", "axle", "wheel", RevoluteJointDef{.anchor = {0, 2}, .motorSpeed = 5, .maxMotorTorque = torque}}};
        const double speed = torque == 1 ? 2 : 5;
        for (const Engine& engine : simulators()) {
            INFO(engine.name << ", " << torque << " Nm");
            CHECK_THAT(endOf(scene, engine, 1).angularVelocity, WithinAbs(speed, 0.01));
            CHECK((endOf(scene, engine, 1).position - Vec2(0, 2)).norm() < 1e-3);
        }
    }
}

TEST_CASE("where Box2D has no counterpart for a shape or material it says so", "[compare][engine]") {
    std::vector<Vec2> nine;
    for (int i = 0; i < 9; ++i) {
        const double angle = 2 * std::numbers::pi * i / 9;
        nine.push_back({std::cos(angle), std::sin(angle)});
    }
    const Engine& box2d24 = engines()[1];
    const auto of = [](const ShapeDef& shape) { return dropped(ground(), shape, 1); };
    CHECK(refusal(box2d24, of(polygon(nine))) == "body body: Box2D 2.4 has no polygon of more than 8 corners");
    CHECK(refusal(box2d24, of(circle(0.5, {.rollingResistance = 0.1}))) ==
          "body body: Box2D 2.4 has no rolling resistance");
    CHECK(refusal(box2d24, of(capsule({0, 0}, {1, 0}, 0.02))).find("skin") != std::string::npos);
    ShapeDef grouped = circle(0.5);
    grouped.filter.group = 40000;
    CHECK(refusal(box2d24, of(grouped)) == "body body: filter group 40000 does not fit Box2D 2.4's 16 bits");
    if (!box2d3()) return;
    CHECK(refusal(*box2d3(), of(polygon(nine))) == "body body: Box2D 3 has no polygon of more than 8 corners");
    const Scene triangle = dropped(loop({{0, 0}, {1, 2}, {3, 0}}), circle(0.5), 3);
    CHECK(refusal(*box2d3(), triangle) == "body floor: Box2D 3 has no ring of fewer than 4 points");
    CHECK(refusal(*box2d3(), of(circle(0.5, {.rollingResistance = 0.1}))) == "none");
}

TEST_CASE("without sleep the settings of each engine say so", "[compare][engine]") {
    Scene scene = dropped(ground(), circle(0.5), 0.5);
    for (const bool sleeping : {true, false}) {
        scene.sleeping = sleeping;
        for (const Engine& engine : simulators()) {
            INFO(engine.name);
            const std::vector<Setting> settings = engine.settings(scene);
            const auto sleep = std::ranges::find(settings, std::string("sleep"), &Setting::first);
            REQUIRE(sleep != settings.end());
            CHECK((sleep->second == "off") == !sleeping);
        }
    }
}

}  // namespace plumb::compare
