// SPDX-License-Identifier: MIT
// Fields among all else that a world does: contacts, regions, filters, sleep, the ledger, bad input.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

BodyDef floorDef() {
    return {.type = BodyType::Static, .position = {0, -0.5}, .shapes = {box({50, 0.5})}};
}

double pressOn(const World& world, BodyId body) {
    double sum = 0;
    for (const Contact& contact : world.body(body).contacts())
        for (const ContactPoint& point : contact.points) sum += point.normalForce;
    return sum;
}

/// One of each kind, all over a room.
void addAllFields(World& world, BodyId carrier) {
    world.addField({.law = UniformGravity{{1, 0}}});
    world.addField({.law = MutualGravity{.constant = 0.5, .softening = 0.5}});
    world.addField({.law = Drag{.linear = 0.1, .quadratic = 0.05, .wind = {2, 0}}});
    world.addField({.law = Attractor{.center = {3, 4}, .strength = 5, .power = 1, .softening = 0.3}});
    world.addField({.law = Magnet{carrier, {.strength = 4, .power = 2, .softening = 0.5}}});
    world.addField({.law = Pool{.fluid = {.density = 2, .surface = {0, 1}}, .drag = 1, .flow = {0.5, 0}}});
    world.addField({.law = GroundFriction{.friction = 0.02}});
    world.addField({.law = UniformGravity{{0, 6}}, .region = boxPolygon({2, 2}, {-4, 2})});
}

World crowdedRoom(Random& random, const WorldDef& def) {
    World world(def);
    world.add({.type = BodyType::Static, .shapes = {loop({{-8, 0}, {8, 0}, {8, 8}, {-8, 8}})}});
    BodyId last;
    for (int i = 0; i < 20; ++i) {
        BodyDef body{.position = {random.uniform(-7, 7), random.uniform(1, 7)},
                     .angle = random.uniform(0, 3),
                     .velocity = {random.uniform(-3, 3), random.uniform(-3, 3)},
                     .linearDamping = random.integer(0, 1) * 0.2};
        const Material material{.restitution = random.uniform(0, 0.8)};
        if (random.integer(0, 1) == 0)
            body.shapes = {circle(random.uniform(0.2, 0.5), material)};
        else
            body.shapes = {roundedBox({random.uniform(0.1, 0.4), random.uniform(0.1, 0.4)}, 0.05, material)};
        const BodyId made = world.add(body);
        if (i % 5 == 4) world.join(RevoluteJointDef{.bodyA = last, .bodyB = made, .anchor = body.position});
        last = made;
    }
    addAllFields(world, last);
    return world;
}

}  // namespace

TEST_CASE("a box of 2 kg in a field of 5 m/s^2 presses on the floor with 29.62 N", "[dynamics][fields]") {
    World world;
    world.add(floorDef());
    const BodyId block = world.add({.position = {0, 0.5}, .shapes = {box({0.5, 0.5}, {.density = 2})}});
    world.addField({.law = UniformGravity{{0, -5}}});
    run(world, 0.5);
    CHECK(pressOn(world, block) == Approx(29.62).epsilon(1e-3));
}

TEST_CASE("a ball in a field bounces to its height, at e = 1 for a minute", "[dynamics][fields]") {
    World world({.gravity = {0, 0}, .ledger = true});
    world.add(floorDef());
    world.addField({.law = UniformGravity{{0, -9.81}}});
    const BodyId ball = world.add({.position = {0, 5.25}, .shapes = {circle(0.25, {.restitution = 1})}});
    double highest = 0;  // of the last bounce, which takes 121 ticks
    for (int tick = 0; tick < 3600; ++tick) {
        world.step(dt);
        if (tick > 3600 - 130) highest = std::max(highest, world.body(ball).position().y());
    }
    CHECK(highest == Approx(5.25).epsilon(2e-3));
    const EnergyLedger e = world.ledger().energy;
    CHECK(std::fabs(e.impacts) < 1e-6);
    CHECK(std::fabs(e.solver) < 1e-6);
}

TEST_CASE("a field acts where its region is, and on what its filter lets in", "[dynamics][fields]") {
    World world({.gravity = {0, 0}});
    world.addField({.law = UniformGravity{{0, 2}}, .region = boxPolygon({1, 1})});
    world.addField({.law = UniformGravity{{3, 0}}, .filter = {.mask = 4}});
    ShapeDef marked = circle(0.2);
    marked.filter.category = 4;
    const BodyId inside = world.add({.shapes = {circle(0.2)}});
    const BodyId outside = world.add({.position = {5, 0}, .shapes = {circle(0.2)}});
    const BodyId chosen = world.add({.position = {0, 5}, .shapes = {marked}});
    run(world, 0.5);
    CHECK((world.body(inside).velocity() - Vec2(0, 1)).norm() < 1e-12);
    CHECK(world.body(outside).velocity().norm() == 0);
    CHECK((world.body(chosen).velocity() - Vec2(1.5, 0)).norm() < 1e-12);
    run(world, 5);
    // It leaves the region at 1 m: sqrt(2 a d), found at the end of a sub-step, g h at most too fast.
    CHECK(world.body(inside).velocity().y() == Approx(2).epsilon(0.01));
}

TEST_CASE("what sleeps wakes when a field comes, changes or goes, and a field of no force wakes nothing later",
          "[dynamics][fields]") {
    World world;
    world.add(floorDef());
    const BodyId block = world.add({.position = {0, 0.5}, .shapes = {box({0.5, 0.5})}});
    const auto settle = [&] {
        run(world, 3);
        return !world.body(block).awake();
    };
    REQUIRE(settle());
    const FieldId field = world.addField({.law = UniformGravity{{0.5, 0}}});
    CHECK(world.body(block).awake());
    REQUIRE(settle());
    world.field(field).set({.law = UniformGravity{{-0.5, 0}}});
    CHECK(world.body(block).awake());
    REQUIRE(settle());
    world.remove(field);
    CHECK(world.body(block).awake());
    REQUIRE(settle());
}

TEST_CASE("a magnet that comes by wakes the nails in its range, and draws them", "[dynamics][fields]") {
    World world;
    world.add(floorDef());
    const BodyId nail = world.add({.position = {0, 0.1}, .shapes = {box({0.1, 0.1}, {.friction = 0.1})}});
    const BodyId far = world.add({.position = {30, 0.1}, .shapes = {box({0.1, 0.1})}});
    const BodyId crane = world.add({.type = BodyType::Kinematic, .position = {-6, 1}, .shapes = {circle(0.1)}});
    world.addField({.law = Magnet{crane, {.strength = 3, .power = 2, .range = 3}}});
    run(world, 3);
    REQUIRE_FALSE(world.body(nail).awake());
    world.body(crane).setVelocity({1, 0});
    run(world, 4.5);
    CHECK(world.body(nail).position().x() < -0.02);
    CHECK_FALSE(world.body(far).awake());
}

TEST_CASE("a parachute that stops in a millisecond does not touch a wall it never reaches", "[dynamics][fields]") {
    World world({.gravity = {0, 0}});
    world.addField({.law = Drag{.linear = 1000}});
    world.add({.type = BodyType::Static, .position = {1, 0}, .shapes = {box({0.1, 5})}});
    const BodyId ball =
        world.add({.velocity = {100, 0}, .mass = Mass{1, {0, 0}, 1}, .shapes = {circle(0.1)}});  // comes 0.1 m far
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        REQUIRE(world.contactBegins().empty());
    }
    CHECK(world.body(ball).position().x() < 0.5);
    CHECK(world.body(ball).position().x() > 0.05);
}

TEST_CASE("a leaf stays in the wind behind a wall's foot: fields do not push through what is solid",
          "[dynamics][fields]") {
    World world;
    world.addField({.law = Drag{.linear = 0.05, .wind = {30, 0}}});
    world.add(floorDef());
    world.add({.type = BodyType::Static, .position = {5, 1}, .shapes = {box({0.2, 3})}});
    const BodyId leaf = world.add({.position = {0, 0.2}, .shapes = {box({0.1, 0.1})}});
    run(world, 10);
    CHECK(world.body(leaf).position().x() == Approx(4.7).margin(0.01));
}

TEST_CASE("an explosion pushes by width and distance, away from its middle, and spares what its filter says",
          "[dynamics][fields]") {
    World world({.gravity = {0, 0}});
    const auto ball = [&](const Vec2& at) {
        return world.add({.position = at, .mass = Mass{2, {0, 0}, 1}, .shapes = {circle(0.5)}});
    };
    const BodyId near = ball({2, 0}), half = ball({0, 4.5}), far = ball({-9, 0});
    const BodyId wall = world.add({.type = BodyType::Static, .position = {0, -3}, .shapes = {box({1, 1})}});
    world.explode({.radius = 3, .falloff = 2, .impulsePerLength = 6});
    CHECK((world.body(near).velocity() - Vec2(3, 0)).norm() < 1e-9);    // 6 N s/m on 1 m, of 2 kg
    CHECK((world.body(half).velocity() - Vec2(0, 1.5)).norm() < 1e-6);  // its nearest point half-way out
    CHECK(world.body(far).velocity().norm() == 0);
    CHECK(world.body(wall).velocity().norm() == 0);
    world.explode({.radius = 30}, {.mask = 2});
    CHECK(world.body(far).velocity().norm() == 0);
    // A plank hit at one end turns.
    const BodyId plank = world.add({.position = {21, 0}, .shapes = {box({1, 0.1})}});
    world.explode({.center = {20, -2}, .radius = 2, .falloff = 1});
    CHECK(world.body(plank).angularVelocity() < -0.1);
    CHECK_THROWS_WITH(world.explode({.radius = -1}), containsText("radius"));
    CHECK_THROWS_WITH(world.explode({.center = {NAN, 0}}), containsText("Explosion.center"));
}

TEST_CASE("in rooms with every field the ledger closes, and a copy goes on to the same bits", "[dynamics][fields]") {
    Random random(61);
    for (int i = 0; i < 12; ++i) {
        CAPTURE(i);
        World world = crowdedRoom(random, {.ledger = true});
        for (int tick = 0; tick < 180; ++tick) {
            world.step(dt);
            const EnergyLedger e = world.ledger().energy;
            const double size = std::fabs(e.kinetic) + std::fabs(e.gravitational) + std::fabs(e.fields) + 1;
            REQUIRE(std::fabs(e.stored() - e.gained()) < 1e-9 * size);
            const MomentumLedger m = world.ledger().momentum;
            REQUIRE((m.momentum - m.gained()).norm() < 1e-9 * (m.momentum.norm() + 10));
            REQUIRE(e.friction < 0.02 * size);
        }
        World copy = world;
        for (int tick = 0; tick < 30; ++tick) {
            world.step(dt);
            copy.step(dt);
        }
        CHECK(stateHash(world) == stateHash(copy));
    }
}

TEST_CASE("a room with every field is the same with a ledger and without, and for any number of lanes",
          "[dynamics][fields]") {
    const auto hashOf = [](const WorldDef& def) {
        Random random(62);
        World world = crowdedRoom(random, def);
        run(world, 4);
        return stateHash(world);
    };
    const std::uint64_t plain = hashOf({});
    CHECK(hashOf({.ledger = true}) == plain);
    for (const int lanes : {1, 4, 8, 16}) CHECK(hashOf({.solver = {.lanes = lanes}}) == plain);
}

TEST_CASE("a field that is no field is refused by name, and a stale or foreign id too", "[dynamics][fields][errors]") {
    World world, other;
    const BodyId foreign = other.add({.shapes = {circle(0.5)}});
    const auto refused = [&](const FieldDef& def, const std::string& text) {
        CHECK_THROWS_WITH(world.addField(def), containsText(text));
        CHECK(world.fields().empty());
    };
    refused({.law = Magnet{foreign, {}}}, "Magnet.body");
    refused({.region = Segment{}}, "FieldDef.region: a line has no area");

    const FieldId field = world.addField({});
    CHECK(world.contains(field));
    CHECK(world.fields() == std::vector{field});
    CHECK_THROWS_AS(other.remove(field), std::invalid_argument);
    CHECK_THROWS_WITH(world.field(field).set({.law = Drag{.linear = -1}}), containsText("linear"));
    CHECK(std::holds_alternative<UniformGravity>(world.field(field).def().law));
    world.remove(field);
    CHECK_FALSE(world.contains(field));
    CHECK_THROWS_WITH(world.field(field), containsText("removed"));
    const FieldId again = world.addField({});
    CHECK_FALSE(again == field);
    CHECK_THROWS_AS(world.remove(field), std::invalid_argument);
}

TEST_CASE("a magnet whose body is removed draws nothing any more, nor does the body that takes its slot",
          "[dynamics][fields]") {
    World world({.gravity = {0, 0}});
    const BodyId carrier = world.add({.position = {2, 0}, .shapes = {circle(0.2)}});
    const BodyId iron = world.add({.shapes = {circle(0.2)}});
    world.addField({.law = Magnet{carrier, {.strength = 5}}});
    world.remove(carrier);
    world.add({.position = {2, 0}, .shapes = {circle(0.2)}});
    run(world, 1);
    CHECK(world.body(iron).velocity().norm() == 0);
}

TEST_CASE("a body is not quarantined for what a field did in the step before to the one that had its slot",
          "[dynamics][fields]") {
    World world;
    world.addField({.law = Attractor{.center = {0, 0}, .strength = 1e300, .range = 1}});
    const BodyId flung = world.add({.position = {0.5, 0}, .shapes = {circle(0.1)}});
    world.step(dt);
    REQUIRE(world.body(flung).quarantined());
    world.remove(flung);

    const BodyId next = world.add({.position = {50, 0}, .awake = false, .shapes = {circle(0.1)}});
    REQUIRE(next.index == flung.index);
    world.body(next).wake();
    world.step(dt);
    CHECK_FALSE(world.body(next).quarantined());
    CHECK(world.body(next).velocity().y() < 0);
}
