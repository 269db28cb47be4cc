// SPDX-License-Identifier: MIT
#include <compare/scene/bench.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <compare/engine/engine.h>
#include <compare/metric/geometry.h>

#include "catch.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

Scene sceneOf(const std::string& name) {
    const std::vector<BenchScene> found = findBenchScenes(name);
    REQUIRE(found.size() == 1);
    return found.front().build();
}

std::size_t shapeCount(const Scene& scene) {
    std::size_t count = 0;
    for (const SceneBody& body : scene.bodies) count += body.def.shapes.size();
    return count;
}

const Shape& shapeOf(const Scene& scene, std::size_t body, std::size_t shape = 0) {
    return scene.bodies.at(body).def.shapes.at(shape).shape;
}

Vec2 positionOf(const Scene& scene, std::size_t body) {
    return scene.bodies.at(body).def.position;
}

/// The largest corner of a polygon around the body's origin: half sizes for a box.
Vec2 halfSizeOf(const Shape& shape) {
    Vec2 most(0, 0);
    for (const Vec2& corner : std::get<Polygon>(shape).vertices) most = most.cwiseMax(corner);
    return most;
}

}  // namespace

TEST_CASE("the six scenes have the peers' numbers of bodies, shapes, joints and steps", "[compare][scene][bench]") {
    struct Numbers {
        const char* name;
        std::size_t bodies, shapes, joints;
        int steps;
        bool sleeping;
    };
    // joint_grid: of 19,800 hinges six would join two discs that are both held
    const Numbers numbers[] = {
        {"large_pyramid", 5051, 5051, 0, 500, false},    {"many_pyramids", 22001, 22020, 0, 200, false},
        {"joint_grid", 10000, 10000, 19794, 500, false}, {"smash", 9601, 9601, 0, 300, true},
        {"tumbler", 2027, 2029, 1, 750, true},           {"spinner", 6078, 6078, 1, 500, true}};
    const std::vector<BenchScene> six = findBenchScenes("six");
    REQUIRE(six.size() == 6);
    for (std::size_t i = 0; i < six.size(); ++i) {
        const Scene scene = six[i].build();
        INFO(scene.name);
        CHECK(six[i].name == numbers[i].name);
        CHECK(scene.name == numbers[i].name);
        CHECK(scene.bodies.size() == numbers[i].bodies);
        CHECK(shapeCount(scene) == numbers[i].shapes);
        CHECK(scene.joints.size() == numbers[i].joints);
        CHECK(stepCount(scene) == numbers[i].steps);
        CHECK(scene.sleeping == numbers[i].sleeping);
        CHECK(scene.gravity == (scene.name == "smash" ? Vec2(0, 0) : Vec2(0, -10)));
        CHECK_NOTHROW(validate(scene));
    }
}

TEST_CASE("the scenes of the group jointed have as many bodies and joints as their table says",
          "[compare][scene][bench]") {
    struct Numbers {
        const char* name;
        std::size_t bodies, joints;
    };
    const Numbers numbers[] = {{"bridge_20", 24, 21},
                               {"truss_32", 66, 128},
                               {"net_20", 400, 754},
                               {"net_40", 1600, 3114},
                               {"cloth_20", 400, 741}};
    const std::vector<BenchScene> jointed = findBenchScenes("jointed");
    REQUIRE(jointed.size() == std::size(numbers));
    for (std::size_t i = 0; i < jointed.size(); ++i) {
        const Scene scene = jointed[i].build();
        INFO(scene.name);
        CHECK(scene.name == numbers[i].name);
        CHECK(scene.bodies.size() == numbers[i].bodies);
        CHECK(scene.joints.size() == numbers[i].joints);
        CHECK_NOTHROW(validate(scene));
    }
}

TEST_CASE("large_pyramid stands row on row from (-49.5, 0.5) to its top at (0, 99.5)", "[compare][scene][bench]") {
    const Scene scene = sceneOf("large_pyramid");
    CHECK(positionOf(scene, 0) == Vec2(0, -1));
    CHECK(halfSizeOf(shapeOf(scene, 0)) == Vec2(100, 1));
    CHECK(positionOf(scene, 1) == Vec2(-49.5, 0.5));
    CHECK(positionOf(scene, 100) == Vec2(49.5, 0.5));
    CHECK(positionOf(scene, 101) == Vec2(-49, 1.5));
    CHECK(positionOf(scene, 5050) == Vec2(0, 99.5));
    CHECK(halfSizeOf(shapeOf(scene, 5050)) == Vec2(0.5, 0.5));
}

TEST_CASE("many_pyramids has 20 floors 220 m wide, 11 m apart, and columns from x = -109 on",
          "[compare][scene][bench]") {
    const Scene scene = sceneOf("many_pyramids");
    for (std::size_t i = 0; i < 20; ++i) {
        const auto& floor = std::get<Segment>(shapeOf(scene, 0, i));
        const double y = 11.0 * static_cast<double>(i);
        CHECK(floor.start == Vec2(-110, y));
        CHECK(floor.end == Vec2(110, y));
    }
    CHECK(positionOf(scene, 1) == Vec2(-109, 0.5));
    CHECK(positionOf(scene, 55) == Vec2(-104.5, 9.5));          // the first one's top
    CHECK(positionOf(scene, 56) == Vec2(-98, 0.5));             // the second column
    CHECK(positionOf(scene, 20 * 55 + 1) == Vec2(-109, 11.5));  // the second row
    CHECK(positionOf(scene, 22000) == Vec2(-109 + 11 * 19 + 4.5, 11 * 19 + 9.5));
}

TEST_CASE("joint_grid holds seven discs of its top row, and hangs each disc on two others", "[compare][scene][bench]") {
    const Scene scene = sceneOf("joint_grid");
    std::set<std::pair<double, double>> held;
    for (const SceneBody& body : scene.bodies) {
        CHECK(std::get<Circle>(body.def.shapes[0].shape).radius == 0.4);
        CHECK(body.def.shapes[0].filter.category == 2);
        CHECK((body.def.shapes[0].filter.mask & 2) == 0);
        if (body.def.type == BodyType::Static) held.insert({body.def.position.x(), body.def.position.y()});
    }
    std::set<std::pair<double, double>> expected;
    for (int k = 47; k <= 53; ++k) expected.insert({k, 0});
    CHECK(held == expected);
    CHECK(positionOf(scene, 0) == Vec2(0, 0));
    CHECK(positionOf(scene, 9999) == Vec2(99, -99));
    const SceneJoint& below = scene.joints.front();
    CHECK(below.bodyA == "disc_0_0");
    CHECK(below.bodyB == "disc_0_1");
    CHECK(std::get<RevoluteJointDef>(below.def).anchor == Vec2(0, -0.5));
    const SceneJoint& beside = scene.joints.back();
    CHECK(beside.bodyA == "disc_98_99");
    CHECK(beside.bodyB == "disc_99_99");
    CHECK(std::get<RevoluteJointDef>(beside.def).anchor == Vec2(98.5, -99));
}

TEST_CASE("smash sends one box of 512 kg at 40 m/s into 120 x 80 sleepers", "[compare][scene][bench]") {
    const Scene scene = sceneOf("smash");
    CHECK(positionOf(scene, 0) == Vec2(-20, 0));
    CHECK(scene.bodies[0].def.velocity == Vec2(40, 0));
    CHECK(massOf(scene.bodies[0].def).mass == 512);
    CHECK(positionOf(scene, 1) == Vec2(30, -16));
    CHECK_THAT(positionOf(scene, 9600).x(), WithinAbs(30 + 119 * 0.4, 1e-12));
    CHECK_THAT(positionOf(scene, 9600).y(), WithinAbs(39 * 0.4, 1e-12));
    CHECK(halfSizeOf(shapeOf(scene, 1)) == Vec2(0.2, 0.2));
    CHECK(scene.bodies[0].def.awake);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) CHECK_FALSE(scene.bodies[i].def.awake);
}

TEST_CASE("tumbler turns four walls of 50 kg/m^2 at 25 degrees a second around (0, 10)", "[compare][scene][bench]") {
    const Scene scene = sceneOf("tumbler");
    CHECK(positionOf(scene, 1) == Vec2(0, 10));
    CHECK_THAT(massOf(scene.bodies[1].def).mass, WithinAbs(4 * 20 * 50, 1e-9));  // walls of 1 m by 20 m
    CHECK(positionOf(scene, 2) == Vec2(-9, 1));
    CHECK_THAT(positionOf(scene, 2026).x(), WithinAbs(8.6, 1e-12));
    CHECK_THAT(positionOf(scene, 2026).y(), WithinAbs(18.6, 1e-12));
    CHECK(halfSizeOf(shapeOf(scene, 2)) == Vec2(0.125, 0.125));
    const auto& motor = std::get<RevoluteJointDef>(scene.joints[0].def);
    CHECK(motor.anchor == Vec2(0, 10));
    CHECK_THAT(motor.motorSpeed, WithinAbs(0.4363323129985824, 1e-15));
    CHECK(motor.maxMotorTorque == 1e8);
}

TEST_CASE("the crowds are three pits, half discs of e = 0.3 and half boxes of e = 0, and a gas that fills 40 %",
          "[compare][scene][bench]") {
    const std::vector<BenchScene> crowds = findBenchScenes("crowds");
    REQUIRE(crowds.size() == 4);
    for (const std::size_t bodies : {200U, 2000U, 5000U}) {
        const Scene scene = sceneOf("pit_" + std::to_string(bodies));
        REQUIRE(scene.bodies.size() == bodies + 1);
        CHECK(stepCount(scene) == 300);
        CHECK_FALSE(scene.sleeping);
        CHECK_NOTHROW(validate(scene));
        std::size_t discs = 0;
        for (std::size_t i = 1; i <= bodies; ++i) {
            const ShapeDef& def = scene.bodies[i].def.shapes[0];
            const bool isDisc = std::holds_alternative<Circle>(def.shape);
            discs += isDisc ? 1 : 0;
            CHECK(def.material.restitution == (isDisc ? 0.3 : 0));
            CHECK(def.material.friction == 0.4);
            CHECK(std::fabs(positionOf(scene, i).x()) < 9 - 0.25);
            if (!isDisc) CHECK(halfSizeOf(def.shape) == Vec2(0.25, 0.25));
        }
        CHECK(discs == bodies / 2);
    }
    const Scene gas = sceneOf("gas_2000");
    REQUIRE(gas.bodies.size() == 2000);
    REQUIRE((gas.wrap.width && gas.wrap.height));
    double area = 0;
    for (const SceneBody& body : gas.bodies) {
        area += 3.141592653589793 * std::pow(std::get<Circle>(body.def.shapes[0].shape).radius, 2);
        CHECK(body.def.shapes[0].material.restitution == 1);
        CHECK_THAT(body.def.velocity.norm(), WithinAbs(1, 1e-12));
    }
    CHECK_THAT(area / (*gas.wrap.width * *gas.wrap.height), WithinAbs(0.4, 1e-12));
    CHECK_NOTHROW(validate(gas));
}

TEST_CASE("spinner stirs 6,076 capsules, discs and squares in a ring of 360 points", "[compare][scene][bench]") {
    const Scene scene = sceneOf("spinner");
    const auto& ring = std::get<Chain>(shapeOf(scene, 0));
    CHECK(ring.closed);
    REQUIRE(ring.points.size() == 360);
    for (const Vec2& point : ring.points) CHECK_THAT((point - Vec2(0, 32)).norm(), WithinAbs(40, 1e-12));
    CHECK((ring.points[90] - Vec2(0, -8)).norm() < 1e-12);  // clockwise: down first
    const auto& paddle = std::get<Polygon>(shapeOf(scene, 1));
    CHECK(halfSizeOf(shapeOf(scene, 1)) == Vec2(0.4, 20));
    CHECK(paddle.radius == 0.2);
    CHECK(scene.bodies[1].def.shapes[0].material.friction == 0);
    const auto& motor = std::get<RevoluteJointDef>(scene.joints[0].def);
    CHECK(motor.motorSpeed == 5);
    CHECK(motor.maxMotorTorque == std::numeric_limits<double>::infinity());
    std::size_t kinds[3] = {0, 0, 0};
    for (std::size_t i = 2; i < scene.bodies.size(); ++i) {
        const ShapeDef& def = scene.bodies[i].def.shapes[0];
        CHECK(def.material.density == 0.25);
        CHECK(def.material.friction == 0.1);
        CHECK(def.material.restitution == 0.1);
        if (std::holds_alternative<Capsule>(def.shape)) ++kinds[0];
        if (std::holds_alternative<Circle>(def.shape)) ++kinds[1];
        if (std::holds_alternative<Polygon>(def.shape)) ++kinds[2];
    }
    CHECK(kinds[0] == 2026);
    CHECK(kinds[1] == 2025);
    CHECK(kinds[2] == 2025);
    CHECK(positionOf(scene, 2) == Vec2(-23, 2));
    CHECK(positionOf(scene, 2 + 91) == Vec2(22.5, 2));
    CHECK(positionOf(scene, 2 + 92) == Vec2(-23, 2.5));
}

TEST_CASE("scaling scenes have 1,000 to 64,000 bodies within 6 %, in two families", "[compare][scene][bench]") {
    const std::vector<BenchScene> scaling = findBenchScenes("scaling");
    CHECK(scaling.size() == 14);
    for (const BenchScene& bench : scaling) {
        const auto wanted = static_cast<double>(std::stoi(bench.name.substr(bench.name.find('_') + 1)));
        if (wanted > 8000) continue;  // made as those are
        const Scene scene = bench.build();
        INFO(scene.name);
        CHECK(scene.name == bench.name);
        CHECK(bench.name.starts_with(bench.family + "_"));
        // a pyramid has 55 boxes: up to 54 of a thousand find no place
        CHECK_THAT(static_cast<double>(scene.bodies.size()), WithinAbs(wanted, 0.06 * wanted));
        CHECK_NOTHROW(validate(scene));
    }
    for (const std::size_t n : {20U, 50U, 200U}) CHECK(sceneOf("small_" + std::to_string(n)).bodies.size() == n);
    CHECK(findBenchScenes("no_such_scene").empty());
}

TEST_CASE("junkyard, compounds, washer and rain have the peers' numbers, and sleep where those do",
          "[compare][scene][bench]") {
    struct Numbers {
        const char* name;
        std::size_t bodies, shapes, joints;
        int steps;
    };
    // ground blocks: 161 + 2 * 50; 81 + 2 * 100 and a segment; 36 wedges and 4 paddles; 5 * 501, and a doll has 13
    // shapes
    const Numbers numbers[] = {{"junkyard", 8002, 8262, 0, 800},
                               {"compounds", 3001, 6282, 0, 500},
                               {"washer", 8101, 8140, 0, 500},
                               {"rain", 11001, 15505, 10000, 1000}};
    for (const Numbers& wanted : numbers) {
        const Scene scene = sceneOf(wanted.name);
        INFO(scene.name);
        CHECK(scene.bodies.size() == wanted.bodies);
        CHECK(shapeCount(scene) == wanted.shapes);
        CHECK(scene.joints.size() == wanted.joints);
        CHECK(stepCount(scene) == wanted.steps);
        CHECK(scene.sleeping);
        CHECK(scene.gravity == Vec2(0, -10));
        CHECK_NOTHROW(validate(scene));
    }
}

TEST_CASE("junkyard pushes 200 columns of 40 pentagons by 60 m sin(0.2 t) to and fro", "[compare][scene][bench]") {
    const Scene scene = sceneOf("junkyard");
    CHECK((positionOf(scene, 1) - Vec2(-75.1, 15)).norm() < 1e-12);    // 1.5 * -200 * 0.25 - 0.1
    CHECK((positionOf(scene, 2) - Vec2(-74.9, 16)).norm() < 1e-12);    // to the other side, a metre up
    CHECK((positionOf(scene, 41) - Vec2(-74.35, 15)).norm() < 1e-12);  // 0.75 m on
    const auto& pentagon = std::get<Polygon>(shapeOf(scene, 1));
    REQUIRE(pentagon.vertices.size() == 5);
    for (const Vec2& corner : pentagon.vertices) CHECK_THAT(corner.norm(), WithinAbs(0.25, 1e-12));
    CHECK(scene.bodies.back().def.type == BodyType::Kinematic);
    const auto& swing = std::get<SwingMotion>(scene.movers.at(0).motion);
    CHECK(swing.amplitude == Vec2(60, 0));
    CHECK(swing.rate == 0.2);
}

TEST_CASE("compounds has two triangles of 1 m^2 a body, washer a drum that turns 25 degrees a second",
          "[compare][scene][bench]") {
    const Scene compounds = sceneOf("compounds");
    CHECK_THAT(massOf(compounds.bodies[1].def).mass, WithinAbs(2 * 1, 1e-12));
    CHECK((positionOf(compounds, 1) - Vec2(-18.75, 5.575)).norm() < 1e-12);
    CHECK((positionOf(compounds, 2) - Vec2(-19.25, 7.825)).norm() < 1e-12);
    const Scene washer = sceneOf("washer");
    const BodyDef& drum = washer.bodies[0].def;
    CHECK_THAT(drum.angularVelocity, WithinAbs(0.4363323129985824, 1e-15));
    CHECK(drum.shapes.size() == 40);
    CHECK((positionOf(washer, 1) - Vec2(-9.9, 0.1)).norm() < 1e-12);
    CHECK((positionOf(washer, 8100) - Vec2(-9.9 + 89 * 0.21, 0.1 + 89 * 0.21)).norm() < 1e-9);
}

TEST_CASE("rain sends 25 dolls every eighth step, and those of 320 steps ago anew", "[compare][scene][bench]") {
    const Scene scene = sceneOf("rain");
    std::map<long, int> comings;
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        ++comings[std::lround(scene.bodies[i].appears / scene.dt)];
        REQUIRE(std::lround(scene.bodies[i].renewed / scene.dt) == 320);
    }
    REQUIRE(comings.size() == 40);
    for (const auto& [step, bodies] : comings) {
        CHECK(step % 8 == 0);
        CHECK(bodies == 25 * 11);
    }
    const auto& elbow = std::get<RevoluteJointDef>(scene.joints.at(7).def);  // of doll_1_left_hand
    CHECK(scene.joints[7].bodyB == "doll_1_left_hand");
    CHECK_THAT(elbow.limit->upper - elbow.limit->lower, WithinAbs(0.5 * std::numbers::pi, 1e-12));
    CHECK_THAT(elbow.maxMotorTorque, WithinAbs(0.005, 1e-15));
    CHECK((elbow.anchor - (positionOf(scene, 1) + Vec2(0, 1.1 - 0.95))).norm() < 1e-12);
}

TEST_CASE("dolls, rope and bridge start without overlap and with closed joints, awake for ever",
          "[compare][scene][bench]") {
    struct Numbers {
        const char* name;
        std::size_t bodies, joints;
        int steps;
    };
    for (const Numbers& wanted :
         {Numbers{"dolls_100", 1001, 900, 600}, Numbers{"dolls_8", 81, 72, 600}, Numbers{"dolls_9", 91, 81, 600},
          Numbers{"rope_60", 61, 59, 400}, Numbers{"bridge_20", 24, 21, 600}}) {
        const Scene scene = sceneOf(wanted.name);
        INFO(scene.name);
        CHECK(scene.bodies.size() == wanted.bodies);
        CHECK(scene.joints.size() == wanted.joints);
        CHECK(stepCount(scene) == wanted.steps);
        CHECK_FALSE(scene.sleeping);
        CHECK(scene.checks.empty());
        CHECK_NOTHROW(validate(scene));
        std::vector<BodyState> start;
        for (const SceneBody& body : scene.bodies) start.push_back({body.def.position, body.def.angle});
        const Geometry geometry(scene);
        CHECK(geometry.penetration(start).value() < 1e-9);
        CHECK(geometry.jointError(start).value() < 1e-9);
    }
    CHECK(sceneOf("rope_60").bodies[60].def.position == Vec2(0.59, 1.1 + 59 * 0.2));
}

TEST_CASE("every engine builds every one of the six and small_50, and steps each twice to finite states",
          "[compare][scene][bench][slow]") {
    std::vector<BenchScene> scenes = findBenchScenes("six");
    scenes.push_back(findBenchScenes("small_50").front());
    for (const BenchScene& bench : scenes) {
        const Scene scene = bench.build();
        for (const Engine& engine : engines()) {
            if (engine.role == Role::Truth) continue;
            INFO(scene.name << " in " << engine.name);
            const std::unique_ptr<Simulation> simulation = engine.build(scene);
            for (int i = 0; i < 2; ++i) simulation->step(scene.dt);
            const std::vector<BodyState> states = simulation->states();
            REQUIRE(states.size() == scene.bodies.size());
            double farthest = 0;  // from where it started [m]
            for (std::size_t i = 0; i < states.size(); ++i) {
                const double moved = (states[i].position - scene.bodies[i].def.position).norm();
                REQUIRE(std::isfinite(moved));
                // the ram of smash is on its way, and the paddle's tip throws what it meets at 100 m/s
                const bool fast = scene.bodies[i].def.velocity != Vec2(0, 0) || scene.name == "spinner";
                if (!fast) farthest = std::max(farthest, moved);
            }
            // two steps of falling are 10 / 60^2 (1 + 2) = 0.8 cm; what starts in overlap is pushed by 4 m/s at most
            CHECK(farthest < 0.15);
        }
    }
}

}  // namespace plumb::compare
