// SPDX-License-Identifier: MIT
// Fields where something else happens: impacts within a step, borders, places where a law has no number, far away.
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/world.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

namespace {

BodyDef wallAt(double x) {
    return {.type = BodyType::Static, .position = {x, 0}, .shapes = {box({0.5, 2}, {.friction = 0, .restitution = 1})}};
}

BodyDef elasticBall(const Vec2& position, const Vec2& velocity, double radius = 0.1) {
    return {.position = position, .velocity = velocity, .shapes = {circle(radius, {.friction = 0, .restitution = 1})}};
}

/// A disc falls on a planet again and again, without loss: what is left of its energy.
double energyLeft(double rate) {
    World world({.gravity = {0, 0}, .ledger = true});
    world.addField({.law = Attractor{.strength = 20}});
    world.add({.type = BodyType::Static, .shapes = {circle(1, {.friction = 0, .restitution = 1})}});
    const BodyId disc = world.add(
        {.position = {0, 1.3}, .mass = Mass{1, {0, 0}, 1}, .shapes = {circle(0.1, {.friction = 0, .restitution = 1})}});
    const double most = 20 / 1.1 - 20 / 1.3;
    run(world, 20, 1 / rate);
    const double height = world.body(disc).position().norm();
    return 0.5 * world.body(disc).velocity().squaredNorm() / most + (20 / 1.1 - 20 / height) / most;
}

}  // namespace

// 5 m/s, mu g = 4.905 m/s^2: it stops after 1.0194 s, having bounced dozens of times.
TEST_CASE("a puck between walls 5 cm apart never speeds up, and stops when the formula says", "[dynamics][fields]") {
    World world({.gravity = {0, 0}, .ledger = true});
    world.addField({.law = GroundFriction{.friction = 0.5}});
    world.add(wallAt(-0.625));
    world.add(wallAt(0.625));
    const BodyId puck = world.add(elasticBall({0, 0}, {5, 0}));
    const double start = world.ledger().energy.kinetic;
    double speed = 5;
    for (int tick = 1; tick <= 61; ++tick) {
        world.step(dt);
        const double now = world.body(puck).velocity().norm();
        REQUIRE(now <= speed);
        REQUIRE(now == Approx(5 - 4.905 * tick * dt).margin(1e-3));
        speed = now;
    }
    run(world, 0.1);
    CHECK(world.body(puck).velocity().norm() == 0);
    const EnergyLedger e = world.ledger().energy;
    CHECK(e.friction == Approx(-start).epsilon(1e-3));
    CHECK(std::fabs(e.solver) < 1e-3 * start);
}

TEST_CASE("an elastic ball bounces on a planet for 20 s, and keeps its height", "[dynamics][fields]") {
    CHECK(energyLeft(60) == Approx(1).margin(0.01));
    CHECK(energyLeft(120) == Approx(1).margin(0.005));
}

TEST_CASE("in a room of elastic balls a drag without motion of the air only takes, and the solver hardly gives",
          "[dynamics][fields]") {
    World world({.gravity = {0, 0}, .ledger = true});
    const Material bouncy{.friction = 0, .restitution = 1};
    world.add({.type = BodyType::Static, .shapes = {loop({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, bouncy)}});
    world.addField({.law = GroundFriction{.friction = 0.05}});
    world.addField({.law = Drag{.quadratic = 0.01}});
    world.addField({.law = Attractor{.strength = 1, .power = 1, .softening = 0.5}});
    for (int i = 0; i < 9; ++i) world.add(elasticBall({i % 3 - 1.0, i / 3 - 1.0}, {3.0 - i, 0.7 * i - 2}, 0.2));
    const double start = world.ledger().energy.stored();
    double before = start;
    for (int tick = 0; tick < 300; ++tick) {
        world.step(dt);
        const double now = world.ledger().energy.stored();
        REQUIRE(now <= before + 1e-3 * std::fabs(start));
        before = now;
    }
    CHECK(std::fabs(world.ledger().energy.solver) < 0.01 * std::fabs(start));
}

TEST_CASE("a field far away changes no bit of what it does not reach", "[dynamics][fields]") {
    const auto hashWith = [](bool field) {
        World world;
        if (field) {
            world.addField({.law = UniformGravity{{0, 5}}, .region = boxPolygon({1, 1}, {1e5, 0})});
            world.addField({.law = Attractor{.center = {1e5, 0}, .range = 10}});
            world.addField({.law = Pool{.fluid = {.surface = {0, -50}}, .drag = 1}});
            world.addField({.law = Drag{.linear = 1}, .filter = {.mask = 4}});
        }
        world.add({.type = BodyType::Static, .shapes = {box({20, 0.5}, {.restitution = 0.5})}});
        for (int i = 0; i < 5; ++i) world.add(elasticBall({2.0 * i, 3.0 + i}, {1, 0}));
        world.add({.position = {-5, 4}, .linearDamping = 0.3, .shapes = {box({0.4, 0.3})}});
        run(world, 3);
        return stateHash(world);
    };
    CHECK(hashWith(true) == hashWith(false));
}

TEST_CASE("what sleeps out of a field's range goes on sleeping when it comes and goes", "[dynamics][fields]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({20, 0.5})}});
    const BodyId block = world.add({.position = {0, 1}, .shapes = {box({0.5, 0.5})}});
    run(world, 3);
    REQUIRE_FALSE(world.body(block).awake());
    const FieldId field = world.addField({.law = Attractor{.center = {0, 1e6}, .range = 1}});
    world.remove(field);
    world.addField({.law = Pool{.fluid = {.surface = {0, 0.2}}}});
    CHECK_FALSE(world.body(block).awake());
}

TEST_CASE("a magnet whose carrier is disabled draws nothing, and what it held wakes", "[dynamics][fields]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({20, 0.5})}});
    const BodyId nail = world.add({.position = {0, 0.6}, .shapes = {box({0.1, 0.1})}});
    const BodyId crane = world.add({.type = BodyType::Static, .position = {0, 3}, .shapes = {circle(0.1)}});
    world.addField({.law = Magnet{crane, {.strength = 0.5}}});
    run(world, 3);
    REQUIRE_FALSE(world.body(nail).awake());
    world.body(crane).setEnabled(false);
    CHECK(world.body(nail).awake());
    run(world, 1);
    double press = 0;
    for (const Contact& contact : world.body(nail).contacts())
        for (const ContactPoint& point : contact.points) press += point.normalForce;
    CHECK(press == Approx(0.04 * 9.81).epsilon(1e-3));
}

TEST_CASE("a magnet on a wall that is enabled wakes what it draws, and no more", "[dynamics][fields]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({20, 0.5})}});
    const BodyId near = world.add({.position = {1, 0.6}, .shapes = {box({0.1, 0.1}, {.friction = 0.1})}});
    const BodyId corner = world.add({.position = {2.9, 0.6}, .shapes = {box({0.1, 0.1})}});
    const BodyId crane =
        world.add({.type = BodyType::Static, .position = {0, 3}, .enabled = false, .shapes = {circle(0.1)}});
    world.addField({.law = Magnet{crane, {.strength = 1, .range = 3}}});
    run(world, 3);
    REQUIRE_FALSE(world.body(near).awake());
    world.body(crane).setEnabled(true);
    CHECK(world.body(near).awake());
    CHECK_FALSE(world.body(corner).awake());  // 3.76 m off, though no farther than 3 m in x and in y
}

TEST_CASE("rounded shapes swim on any water, however far from the origin", "[dynamics][fields]") {
    std::vector<Vec2> corners;
    for (int i = 0; i < 64; ++i) corners.push_back(Vec2(std::cos(i * 0.09817477), std::sin(i * 0.09817477)) * 0.05);
    for (const double x : {1e3, 1.7e10, 2.2e12, 9e14}) {
        World world;
        world.addField({.law = Pool{.fluid = {.density = 2, .surface = {x, 0}}, .drag = 10}});
        const BodyId raft = world.add({.position = {x, 0}, .shapes = {{.shape = Polygon{corners, 0.01}}}});
        REQUIRE_NOTHROW(run(world, 10));
        INFO(x << " m off");
        CHECK(std::fabs(world.body(raft).position().y()) < 1e-3);
    }
}

TEST_CASE("where a law has no number the ledger still has", "[dynamics][fields]") {
    World world({.gravity = {0, 0}, .ledger = true});
    const FieldId point = world.addField({.law = Attractor{}});
    const FieldId mutual = world.addField({.law = MutualGravity{.constant = 1}});
    const FieldId wide = world.addField({.law = Attractor{.power = 1, .range = 1e200}});
    world.add({.shapes = {circle(0.5, {.density = 1})}});
    world.add({.shapes = {{.shape = Circle{0.5}, .sensor = true}, {.shape = Circle{0.2}, .filter = {.mask = 0}}}});
    const auto isSound = [&] {
        const EnergyLedger e = world.ledger().energy;
        return std::isfinite(e.stored()) && std::isfinite(e.gained()) && std::isfinite(e.solver);
    };
    for (int tick = 0; tick < 10; ++tick) {
        world.step(dt);
        REQUIRE(isSound());
    }
    world.remove(point);
    world.remove(mutual);
    world.remove(wide);
    world.step(dt);
    CHECK(isSound());
}

TEST_CASE("a step too short for numbers harms nothing in a field", "[dynamics][fields]") {
    World world;
    world.addField({.law = Drag{.quadratic = 1}});
    const BodyId disc = world.add(elasticBall({0, 0}, {3, 0}));
    for (const double tiny : {1e-10, 1e-160, 1e-300}) world.step(tiny);
    CHECK_FALSE(world.body(disc).quarantined());
    CHECK(world.body(disc).velocity().x() == Approx(3));
}
