// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/collide/sweep.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"

using namespace plumb;
using namespace plumb::test;

namespace {

ShapeDef sensorOf(ShapeDef shape) {
    shape.sensor = true;
    shape.material.density = 0;
    return shape;
}

/// A disc, box or capsule of about this radius.
ShapeDef someShape(Random& random, double radius, const Material& material) {
    const int kind = random.integer(0, 2);
    if (kind == 0) return circle(radius, material);
    if (kind == 1) return box({radius, radius * random.uniform(0.4, 1)}, material);
    return capsule({-0.5 * radius, 0}, {0.5 * radius, 0}, 0.5 * radius, material);
}

/// One body that something moves fast in the step, and one that only passes or waits. One of the two has the sensor.
struct VisitScene {
    World world = weightless();
    BodyId driven, other;
    double dt = 0;
    bool isStruck = false;  ///< the driven body may rest, be struck once, and fly
    std::string what;
};

ShapeDef gateOf(Random& random, bool sensor) {
    const double thickness = random.integer(0, 1) == 0 ? 0.01 : random.uniform(0.05, 0.4);
    ShapeDef shape = box({thickness, random.uniform(0.2, 0.9)});
    if (random.integer(0, 2) == 0) shape = circle(random.uniform(0.02, 0.4));
    if (random.integer(0, 2) == 0) shape = capsule({0, -0.5}, {0, 0.5}, std::max(thickness, 0.02));
    return sensor ? sensorOf(shape) : shape;
}

void addStruck(VisitScene& scene, Random& random, const BodyDef& driven) {
    const Material material{.friction = random.uniform(0, 0.5), .restitution = random.uniform(0, 1)};
    BodyDef def = driven;
    for (ShapeDef& shape : def.shapes)
        if (!shape.sensor) shape.material = material;
    scene.driven = scene.world.add(def);
    const double speed = random.uniform(0.6, 2.5) / scene.dt;
    const double distance = random.uniform(0.45, 1.2);
    scene.world.add({.position = {-distance, random.uniform(-0.1, 0.1)},
                     .velocity = {speed, 0},
                     .shapes = {circle(0.2, {.density = 5, .restitution = material.restitution})}});
    scene.isStruck = true;
}

/// It lies on a floor and against a row of others, so the solver moves it.
void addPressed(VisitScene& scene, Random& random, const BodyDef& driven) {
    scene.world.setGravity({0, -9.81});
    scene.world.add({.type = BodyType::Static, .shapes = {segment({-20, -0.2}, {20, -0.2})}});
    BodyDef def = driven;
    scene.driven = scene.world.add(def);
    const int row = random.integer(0, 2);
    for (int i = 1; i <= row; ++i) scene.world.add({.position = {-0.4 * i, 0}, .shapes = {box({0.2, 0.2})}});
    for (int tick = 0; tick < 10; ++tick) scene.world.step(scene.dt);
    scene.world.add({.position = {-0.4 * row - 0.6, 0.02},
                     .velocity = {random.uniform(0.6, 2.5) / scene.dt, 0},
                     .shapes = {box({0.19, 0.19}, {.density = 30, .restitution = random.uniform(0, 1)})}});
    scene.isStruck = true;
}

void addPulled(VisitScene& scene, Random& random, const BodyDef& driven) {
    const BodyId ground = scene.world.add({.type = BodyType::Static, .position = {0, -9}});
    scene.driven = scene.world.add(driven);
    const double mass = scene.world.body(scene.driven).mass();
    if (random.integer(0, 1) == 0)
        scene.world.join(PrismaticJointDef{.bodyA = ground,
                                           .bodyB = scene.driven,
                                           .anchor = {0, 0},
                                           .axis = {1, 0},
                                           .motorSpeed = random.uniform(0.5, 2.5) / scene.dt,
                                           .maxMotorForce = 1e9});
    else
        scene.world.join(DistanceJointDef{.bodyA = ground,
                                          .bodyB = scene.driven,
                                          .anchorA = {random.uniform(10, 60), 0},
                                          .anchorB = {0, 0},
                                          .length = 1,
                                          .spring = springOf(0.2 / scene.dt, 0.3, mass)});
}

void addPushed(VisitScene& scene, Random& random, const BodyDef& driven) {
    scene.driven = scene.world.add(driven);
    scene.world.add({.type = BodyType::Kinematic,
                     .position = {-random.uniform(0.5, 0.9), random.uniform(-0.1, 0.1)},
                     .velocity = {random.uniform(0.4, 2) / scene.dt, 0},
                     .shapes = {box({0.2, 0.5}, {.restitution = random.uniform(0, 1)})}});
    scene.isStruck = true;
}

VisitScene sceneOf(Random& random) {
    VisitScene scene;
    scene.dt = std::array{1.0 / 30, 1.0 / 60, 1.0 / 120}[static_cast<std::size_t>(random.integer(0, 2))];
    const bool carries = random.integer(0, 3) == 0;
    BodyDef driven{.position = {0, 0}, .shapes = {someShape(random, 0.2, {})}};
    const int way = random.integer(0, 3);
    if (carries) {
        driven.shapes.push_back(gateOf(random, true));
        driven.shapes.back().filter.mask = 2;
        for (ShapeDef& shape : driven.shapes) shape.filter.category = 4;
    }
    BodyDef other;
    other.type = static_cast<BodyType>(random.integer(0, 2));
    const double there = random.uniform(0.3, 3), angle = random.uniform(-1.5, 1.5);
    other.position = {there, random.uniform(-0.3, 0.3)};
    other.angle = angle;
    other.shapes = {gateOf(random, !carries)};
    other.shapes.front().filter.category = 2;
    if (carries) other.shapes.front().filter.mask = 4;
    if (other.type == BodyType::Dynamic && !carries) {
        other.shapes.push_back(circle(0.05));
        other.shapes.back().filter.mask = 0;
    }
    if (other.type != BodyType::Static && random.integer(0, 1) == 0) {
        other.velocity = {random.uniform(-0.5, 0.5) / scene.dt, random.uniform(-0.5, 0.5) / scene.dt};
        other.angularVelocity = random.uniform(-0.5, 0.5) / scene.dt;
    }
    if (carries) {  // the two bodies only see each other by the sensor
        other.shapes.front().filter.group = 0;
        driven.shapes.front().filter.mask = ~std::uint64_t{2};
    }
    if (way == 0) addStruck(scene, random, driven);
    if (way == 1) addPressed(scene, random, driven);
    if (way == 2) addPulled(scene, random, driven);
    if (way == 3) addPushed(scene, random, driven);
    if (way == 1) other.position = {there, std::max(other.position.y(), 0.0)};
    scene.other = scene.world.add(other);
    scene.what = std::string("way ") + std::to_string(way) + (carries ? ", carried sensor" : ", other sensor") +
                 ", other type " + std::to_string(static_cast<int>(other.type));
    return scene;
}

struct SeenPlace {
    Vec2 center{0, 0};
    double angle = 0;
    Vec2 velocity{0, 0};
    double spin = 0;
};

SeenPlace placeOfBody(const World& world, BodyId id) {
    const auto body = world.body(id);
    return {body.position(), body.angle(), body.velocity(), body.angularVelocity()};
}

Transform between(const SeenPlace& from, const SeenPlace& to, double share) {
    return {from.center + (to.center - from.center) * share,
            Rot::fromAngle(from.angle + (to.angle - from.angle) * share)};
}

/// Where a body was that rested, was struck at some time in the step, and has flown since.
Transform sinceStruck(const SeenPlace& from, const SeenPlace& to, double left) {
    const double flight = to.velocity.norm() > 0 ? (to.center - from.center).norm() / to.velocity.norm() : 0;
    const double back = std::min(left, flight);
    return {to.center - to.velocity * back, Rot::fromAngle(to.angle - to.spin * back)};
}

/// The least distance of two shapes on the way between the places of two steps, at 400 times [m]. A sensor that moves
/// beside a body that was struck: the larger of the least distances on the straight way and on the real one.
struct Least {
    double surely = 0, perhaps = 0;  ///< [m]
};

Least leastSeparation(const VisitScene& scene, const std::array<SeenPlace, 2>& driven,
                      const std::array<SeenPlace, 2>& other) {
    const auto shapeOf = [&](BodyId id, bool sensor) {
        const std::vector<ShapeId> shapes = scene.world.body(id).shapes();
        const bool first = scene.world.shape(shapes.front()).sensor() == sensor;
        return scene.world.shape(first ? shapes.front() : shapes.back()).def().shape;
    };
    const bool carries = scene.world.shape(scene.world.body(scene.driven).shapes().back()).sensor();
    const Shape own = shapeOf(scene.driven, carries), there = shapeOf(scene.other, !carries);
    std::array<double, 2> least{1e9, 1e9};
    constexpr int samples = 400;
    for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const Transform at = between(other[0], other[1], share);
        const std::array<Transform, 2> ways{between(driven[0], driven[1], share),
                                            scene.isStruck ? sinceStruck(driven[0], driven[1], (1 - share) * scene.dt)
                                                           : between(driven[0], driven[1], share)};
        for (std::size_t w = 0; w < 2; ++w)
            least[w] = std::min(least[w], plumb::distance(own, ways[w], there, at).separation);
    }
    return {std::max(least[0], least[1]), std::min(least[0], least[1])};
}

/// Has a body that flies made another turn than it would have since a single impact? Then it was struck twice, and
/// sampling does not know its path.
bool isStruckTwice(const SeenPlace& from, const SeenPlace& to) {
    const double flight = to.velocity.norm() > 0 ? (to.center - from.center).norm() / to.velocity.norm() : 0;
    return std::fabs(to.angle - from.angle - to.spin * flight) > 0.05;
}

struct VisitTally {
    int visits = 0, missed = 0, madeUp = 0;
    std::string first;
};

/// Steps a scene, and compares the begins of its two bodies with what sampling sees.
void check(VisitScene& scene, VisitTally& tally) {
    bool inside = false;
    for (int tick = 0; tick < 6; ++tick) {
        std::array<SeenPlace, 2> driven, other;
        driven[0] = placeOfBody(scene.world, scene.driven);
        other[0] = placeOfBody(scene.world, scene.other);
        scene.world.step(scene.dt);
        driven[1] = placeOfBody(scene.world, scene.driven);
        other[1] = placeOfBody(scene.world, scene.other);
        bool began = false, ended = false;
        const auto isBoth = [&](BodyId a, BodyId b) {
            return (a == scene.driven && b == scene.other) || (b == scene.driven && a == scene.other);
        };
        for (const SensorBegin& e : scene.world.sensorBegins()) began = began || isBoth(e.sensor.body, e.visitor.body);
        for (const SensorEnd& e : scene.world.sensorEnds()) ended = ended || isBoth(e.sensor.body, e.visitor.body);
        const Least least = leastSeparation(scene, driven, other);
        const double moved = (driven[1].center - driven[0].center).norm() + (other[1].center - other[0].center).norm();
        const double sampling =
            0.01 * (moved + std::fabs(driven[1].angle - driven[0].angle) + std::fabs(other[1].angle - other[0].angle));
        const std::string where = scene.what + ", tick " + std::to_string(tick) + ", distance " +
                                  std::to_string(least.surely) + ", moved " + std::to_string(moved);
        const bool known = !scene.isStruck || !isStruckTwice(driven[0], driven[1]);
        if (!inside && known && least.surely < -1e-3) {
            ++tally.visits;
            if (!began) ++tally.missed;
            if (!began && tally.first.empty()) tally.first = "missed: " + where;
        }
        if (began && known && least.perhaps > sampling + 1e-3) {
            ++tally.madeUp;
            if (tally.first.empty()) tally.first = "made up: " + where;
        }
        inside = (inside || began) && !ended;
    }
}

}  // namespace

TEST_CASE("a resting ball that is struck and flies through a thin sensor in the same step begins and ends in it",
          "[dynamics][sensor]") {
    World world = weightless();
    const Material elastic{.friction = 0, .restitution = 1};
    const BodyId ball = world.add({.shapes = {circle(0.2, elastic)}});
    world.add({.position = {-0.7, 0}, .velocity = {60, 0}, .shapes = {circle(0.2, elastic)}});
    world.add({.type = BodyType::Static, .position = {0.27, 0}, .shapes = {sensorOf(box({0.05, 0.7}))}});
    world.step(dt);
    REQUIRE(world.sensorBegins().size() == 1);
    CHECK(world.sensorBegins()[0].visitor.body == ball);
    REQUIRE(world.sensorEnds().size() == 1);
    CHECK(world.sensorEnds()[0].visitor.body == ball);
}

TEST_CASE("what was struck into a sensor ends its visit when the sensor is removed at once", "[dynamics][sensor]") {
    World world = weightless();
    const Material elastic{.friction = 0, .restitution = 1};
    world.add({.shapes = {circle(0.2, elastic)}});
    world.add({.position = {-0.7, 0}, .velocity = {60, 0}, .shapes = {circle(0.2, elastic)}});
    const BodyId gate =
        world.add({.type = BodyType::Static, .position = {1.5, 0}, .shapes = {sensorOf(box({1, 0.7}))}});
    world.step(dt);
    REQUIRE(world.sensorBegins().size() == 1);
    CHECK(world.sensorEnds().empty());
    world.remove(gate);
    world.step(dt);
    CHECK(world.sensorBegins().empty());
    CHECK(world.sensorEnds().size() == 1);
}

TEST_CASE("1,000 bodies that are struck, pushed or pulled begin each visit in the step in which sampling sees it",
          "[dynamics][sensor][law][slow]") {
    Random random(71);
    VisitTally tally;
    for (int round = 0; round < 1000; ++round) {
        VisitScene scene = sceneOf(random);
        check(scene, tally);
    }
    INFO(tally.first);
    CHECK(tally.visits > 300);
    CHECK(tally.missed == 0);
    CHECK(tally.madeUp == 0);
}
