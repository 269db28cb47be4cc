// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/edited.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("shapes added and removed 200 times weigh what they weigh together", "[dynamics][editing]") {
    Random random(5);
    World world({.gravity = {0, 0}});
    std::vector<ShapeDef> kept{circle(0.3)};
    const BodyId body = world.add(spinning(kept));
    for (int i = 0; i < 200; ++i) {
        const std::vector<ShapeId> ids = world.body(body).shapes();
        REQUIRE(ids.size() == kept.size());
        if (kept.size() < 2 || random.integer(0, 1) == 0) {
            const double x = random.uniform(-3, 3);
            kept.push_back(shapeAt({x, 1}));
            CHECK(world.add(body, kept.back()).number > ids.back().number);
        } else {
            const int which = random.integer(0, static_cast<int>(kept.size()) - 1);
            world.remove(ids[static_cast<std::size_t>(which)]);
            kept.erase(kept.begin() + which);
        }
        world.step(dt);
        World fresh;
        const BodyId same = fresh.add(spinning(kept));
        REQUIRE(world.body(body).mass() == fresh.body(same).mass());
        REQUIRE(world.body(body).inertia() == fresh.body(same).inertia());
    }
}

TEST_CASE("numbers of shapes count on, and a removed one's is refused for ever", "[dynamics][editing]") {
    World world;
    const BodyId body = world.add({.shapes = {circle(1), circle(2)}});
    world.remove(ShapeId{body, 1});
    const ShapeId third = world.add(body, circle(3));
    CHECK(third.number == 2);
    CHECK(world.body(body).shapes() == std::vector<ShapeId>{{body, 0}, {body, 2}});
    CHECK(world.contains(third));
    CHECK_FALSE(world.contains(ShapeId{body, 1}));
    CHECK_THROWS_WITH(world.shape({body, 1}).def(), containsText("ShapeId.number: 1 names no shape of that body"));
    CHECK_THROWS_WITH(world.shape({body, 7}).set({}), containsText("ShapeId.number: 7"));
    CHECK_THROWS_WITH(world.remove(ShapeId{{}, 0}), containsText("ShapeId.body"));
    world.shape({body, 0}).set(plumb::box({1, 1}));
    CHECK(world.body(body).shapes() == std::vector<ShapeId>{{body, 0}, {body, 2}});
    CHECK(std::get<Polygon>(world.shape({body, 0}).def().shape).vertices.size() == 4);
}

TEST_CASE("a shape is given back as it was given, a chain whole", "[dynamics][editing]") {
    World world;
    ShapeDef path = chain({{0, 0}, {1, 0}, {2, 1}, {5, 2}}, {.friction = 0.3}), ring = path, line = path;
    ring.shape = Chain{{{0, 0}, {1, 0}, {0, 1}}, true};
    line.shape = Chain{{{0, 0}, {1, 0}}};
    ShapeDef one = segment({0, 0}, {1, 1});
    one.tag = 99;
    one.oneWay = Vec2(0, 1);
    const BodyId body = world.add({.type = BodyType::Static, .shapes = {path, one, ring, line}});
    CHECK(world.shape({body, 0}).def().shape == path.shape);
    CHECK(world.shape({body, 0}).material().friction == 0.3);
    CHECK(world.shape({body, 1}).def().shape == one.shape);
    CHECK(world.shape({body, 1}).tag() == 99);
    CHECK(*world.shape({body, 1}).def().oneWay == Vec2(0, 1));
    CHECK(world.shape({body, 2}).def().shape == ring.shape);
    CHECK(world.shape({body, 3}).def().shape == line.shape);
    world.shape({body, 0}).set(one);  // one piece in the place of three
    CHECK(world.shape({body, 0}).def().shape == one.shape);
    CHECK(world.shape({body, 2}).def().shape == ring.shape);
    CHECK(world.body(body).shapes().size() == 4);
}

TEST_CASE("a stack of ten whose bottom box gets another friction or tag stands as if it had not, and no touch ends",
          "[dynamics][editing]") {
    for (const bool friction : {true, false}) {
        World edited({.sleeping = false}), left({.sleeping = false});
        const BodyId bottom = stackOf(edited, 10)[0];
        const std::vector<BodyId> boxes = stackOf(left, 10);
        steps(edited, 300);
        steps(left, 300);
        ShapeDef def = edited.shape({bottom, 0}).def();
        (friction ? def.material.friction : def.material.rollingResistance) = 0.55;
        edited.shape({bottom, 0}).set(def);
        for (int tick = 0; tick < 30; ++tick) {
            edited.step(dt);
            left.step(dt);
            CHECK(edited.contactBegins().size() + edited.contactEnds().size() == 0);
            for (std::size_t i = 0; i < boxes.size(); ++i)
                CHECK((edited.body(edited.bodies()[i + 1]).position() - left.body(boxes[i]).position()).norm() < 2e-5);
        }
    }
}

TEST_CASE("a box on the floor that grows ten times as heavy keeps its touch and presses with 98.1 N",
          "[dynamics][editing]") {
    Rest rest;
    World& world = rest.world;
    world.body(rest.box).setMass({10, {0, 0}, 10.0 / 6});
    for (int tick = 0; tick < 10; ++tick) {
        world.step(dt);
        CHECK(world.contactBegins().size() + world.contactEnds().size() == 0);
    }
    double force = 0;
    const Contact contact = world.body(rest.box).contacts()[0];
    for (const ContactPoint& point : contact.points) force += point.normalForce;
    CHECK(std::fabs(force - 98.1) < 0.5);
    CHECK(world.body(rest.box).inertia() == 10.0 / 6);
    world.body(rest.box).setMassFromShapes();
    CHECK(world.body(rest.box).mass() == 1);
}

TEST_CASE("a box whose centre of mass is moved beyond its support tips over, and its contacts stay where they are",
          "[dynamics][editing]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {segment({-5, 0}, {0, 0})}});
    const BodyId box = world.add({.position = {-0.2, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    steps(world, 60);
    world.body(box).setMass({1, {0.3, 0}, 0.2});
    world.step(dt);
    REQUIRE(world.body(box).contacts().size() == 1);
    const Contact contact = world.body(box).contacts()[0];
    for (const ContactPoint& point : contact.points) CHECK(std::fabs(point.position.y()) < 2e-3);
    steps(world, 60);
    CHECK(world.body(box).position().y() < 0.3);
}

TEST_CASE("a given mass outlasts new shapes and a time as a static body", "[dynamics][editing]") {
    World world;
    const BodyId body = world.add({.mass = Mass{3, {0.1, 0}, 2}, .shapes = {circle(1)}});
    world.add(body, circle(5));
    CHECK(world.body(body).mass() == 3);
    world.body(body).setType(BodyType::Static);
    CHECK(world.body(body).mass() == 0);
    world.body(body).setType(BodyType::Kinematic);
    world.body(body).setType(BodyType::Dynamic);
    CHECK(world.body(body).mass() == 3);
    CHECK(world.body(body).inertia() == 2);
    CHECK((world.body(body).centerOfMass() - Vec2(0.1, 0)).norm() < 1e-15);
}

TEST_CASE("a filter that lets in what it kept out finds what lies there, wider, it keeps the touch",
          "[dynamics][editing]") {
    Rest rest;
    World& world = rest.world;
    ShapeDef def = world.shape({rest.plank, 0}).def();
    def.filter.category = 3;
    world.shape({rest.plank, 0}).set(def);
    world.step(dt);
    CHECK(world.contactBegins().size() + world.contactEnds().size() == 0);
    CHECK(world.body(rest.box).contacts().size() == 1);
    def.filter.mask = 2;
    world.shape({rest.plank, 0}).set(def);
    world.step(dt);
    CHECK(world.contactEnds().size() == 1);
    def.filter.mask = 3;
    world.shape({rest.plank, 0}).set(def);
    steps(world, 60);
    CHECK(std::fabs(world.body(rest.box).position().y() - 1) < 5e-3);
    CHECK(world.body(rest.box).contacts().size() == 1);
}

TEST_CASE("a filter decides anew who is in a sensor", "[dynamics][editing][sensor]") {
    World world({.gravity = {0, 0}});
    ShapeDef gate = circle(1);
    gate.sensor = true;
    const BodyId sensor = world.add({.type = BodyType::Static, .shapes = {gate}});
    world.add({.shapes = {circle(0.5)}});
    steps(world, 3);
    for (int i = 0; i < 4; ++i) {
        gate.filter.mask = i % 2 == 0 ? 2 : 1;
        world.shape({sensor, 0}).set(gate);
        world.step(dt);
        CHECK(world.sensorEnds().size() == (i % 2 == 0 ? 1 : 0));
        CHECK(world.sensorBegins().size() == (i % 2 == 0 ? 0 : 1));
        world.step(dt);
        CHECK(world.sensorEnds().size() + world.sensorBegins().size() == 0);
    }
}

TEST_CASE("a floor made a sensor lets a ball through and tells of it, solid again, it holds the next",
          "[dynamics][editing][sensor]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {plumb::box({5, 0.5})}});
    const BodyId ball = world.add({.position = {0, 1}, .shapes = {circle(0.5)}});
    steps(world, 60);
    ShapeDef def = world.shape({floor, 0}).def();
    def.sensor = true;
    world.shape({floor, 0}).set(def);
    std::size_t begins = 0, ends = 0;
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        begins += world.sensorBegins().size();
        ends += world.sensorEnds().size();
    }
    CHECK(begins == 1);
    CHECK(ends == 1);
    CHECK(world.body(ball).position().y() < -1);
    world.body(ball).setPose({0, 1}, 0);
    world.body(ball).setVelocity({0, 0});
    def.sensor = false;
    world.shape({floor, 0}).set(def);
    steps(world, 60);
    CHECK(std::fabs(world.body(ball).position().y() - 1) < 1e-3);
}
