// SPDX-License-Identifier: MIT
#include <plumb/dynamics/field_def.h>

#include <cmath>

#include <plumb/dynamics/world.h>
#include <plumb/record/state_hash.h>

#include "catch.h"
#include "kit/dynamics/worlds.h"
#include "kit/usual_world.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

BodyId disc(World& world, const Vec2& position, const Vec2& velocity, double mass = 1, double radius = 0.1) {
    return world.add({.position = position,
                      .velocity = velocity,
                      .mass = Mass{.mass = mass, .center = {0, 0}, .inertia = 0.5 * mass * radius * radius},
                      .shapes = {circle(radius)}});
}

}  // namespace

TEST_CASE("a uniform field of 4 m/s^2 throws as gravity does, to rounding", "[dynamics][fields]") {
    World world = weightless();
    world.addField({.law = UniformGravity{{0, -4}}});
    const BodyId ball = disc(world, {0, 0}, {3, 5});
    run(world, 2);
    CHECK((world.body(ball).position() - Vec2(6, 2)).norm() < 1e-12);  // 5 2 - 4 2^2 / 2
    CHECK((world.body(ball).velocity() - Vec2(3, -3)).norm() < 1e-12);
}

// Kepler: T = 2 pi sqrt(a^3 / (G M)). e = 0.5, a = 10 m, G M = 1000: T = 6.2831853 s, started at the far end, where the
// speed is sqrt(G M (1 - e) / (a (1 + e))).
TEST_CASE("two bodies go round each other as Kepler says", "[dynamics][fields]") {
    World world = weightless();
    world.addField({.law = MutualGravity{.constant = 1}});
    const double speed = std::sqrt(1000 * 0.5 / 15);
    const BodyId heavy = disc(world, {0, 0}, {0, 0}, 750), light = disc(world, {15, 0}, {0, speed}, 250);
    Vec2 middle = 0.75 * world.body(heavy).position() + 0.25 * world.body(light).position();
    const Vec2 drift(0, 0.25 * speed);
    const int ticks = 377;  // 6.28333 s: 0.15 ms past one round
    for (int tick = 0; tick < ticks; ++tick) world.step(dt);
    const double late = ticks * dt - 2 * pi;
    const Vec2 apart = world.body(light).position() - world.body(heavy).position();
    // Verlet at h = 1/240 s is late by (n h)^2 / 24 of its phase at most, weighted towards the near end, where the
    // angular speed is 6 times the mean: less than 2e-4 of the way round.
    CHECK((apart - Vec2(15, speed * late)).norm() < 2e-4 * 2 * pi * 15);
    middle += drift * (ticks * dt);
    CHECK((0.75 * world.body(heavy).position() + 0.25 * world.body(light).position() - middle).norm() < 1e-11);
}

TEST_CASE("an orbit keeps its energy for 100 rounds", "[dynamics][fields][slow]") {
    World world({.gravity = {0, 0}, .ledger = true});
    world.addField({.law = Attractor{.strength = 100, .power = 2}});
    disc(world, {10, 0}, {0, 2}, 1);
    const double start = world.ledger().energy.stored();
    double worst = 0;
    for (int i = 0; i < 100 * 28; ++i) {  // a = 8.33 m, T = 15.1 s
        run(world, 0.54);
        worst = std::max(worst, std::fabs(world.ledger().energy.stored() - start));
    }
    CHECK(worst < 1e-4 * std::fabs(start));
}

TEST_CASE("a world's drag brings what falls to its terminal speed", "[dynamics][fields][facts]") {
    World world;
    // Textbook: c = 0.005 /m, v_t = 44.294469181 m/s; after 3 s 25.748172225 m/s, fallen 41.234527650 m.
    world.addField({.law = Drag{.quadratic = 0.005}});
    const BodyId ball = disc(world, {0, 0}, {0, 0});
    run(world, 3);
    // Second order in 1/240 s: c g h t of the speed in 1 / 12 at most.
    CHECK(world.body(ball).velocity().y() == Approx(-25.748172225).epsilon(1e-6));
    CHECK(world.body(ball).position().y() == Approx(-41.234527650).epsilon(1e-6));
    run(world, 60);
    CHECK(world.body(ball).velocity().y() == Approx(-44.294469181).epsilon(1e-9));
}

TEST_CASE("linear drag and wind carry a ball as the closed form says, to rounding", "[dynamics][fields]") {
    World world;
    world.addField({.law = Drag{.linear = 0.4, .wind = {-5, 0}}});
    const BodyId ball = disc(world, {0, 0}, {14, 14}, 2);  // k / m = 0.2 /s
    run(world, 2);
    // x = (u - c) E + c t, c = W + g / k, E = (1 - e^(-k t)) / k
    const double k = 0.2, e = (1 - std::exp(-k * 2)) / k;
    const Vec2 c(-5, -9.81 / k), u(14, 14);
    const Vec2 expected = (u - c) * e + c * 2;
    CHECK((world.body(ball).position() - expected).norm() < 1e-12);
}

TEST_CASE("a puck on the ground stops where the formula says", "[dynamics][fields]") {
    World world = weightless();
    world.addField({.law = GroundFriction{.friction = 0.25}});
    const BodyId puck = disc(world, {0, 0}, {3, 4});
    run(world, 4);
    // v^2 / (2 mu g) = 5.0968399592 m; the last half of a sub-step is rounded off: mu g h^2 = 4e-5 m
    CHECK((world.body(puck).position() - 5.0968399592 * Vec2(0.6, 0.8)).norm() < 5e-5);
    CHECK(world.body(puck).velocity().norm() == 0);
    run(world, 1);
    CHECK_FALSE(world.body(puck).awake());
}

TEST_CASE("what friction holds on the ground is not moved by less than it bears", "[dynamics][fields]") {
    World world = weightless();
    world.addField({.law = GroundFriction{.friction = 0.5}});
    const BodyId a = world.add({.shapes = {box({0.5, 0.5})}}),
                 b = world.add({.position = {1, 0}, .shapes = {box({0.5, 0.5})}});
    for (int tick = 0; tick < 120; ++tick) {  // the two together bear 9.81 N
        world.body(a).applyForce({9, 0});
        world.step(dt);
    }
    CHECK(world.body(b).position().x() < 1.005);
    for (int tick = 0; tick < 120; ++tick) {
        world.body(a).applyForce({11.81, 0});
        world.step(dt);
    }
    // 2 N too many move 2 kg: 1 m/s^2 for 2 s
    CHECK(world.body(b).position().x() == Approx(3).epsilon(0.01));
}

TEST_CASE("a box of half the water's density floats half sunk, upright or not", "[dynamics][fields]") {
    World world;
    world.addField({.law = Pool{.fluid = {.density = 1000}, .drag = 3000}});
    const BodyId raft = world.add({.position = {0, 1}, .angle = 0.1, .shapes = {box({1, 0.25}, {.density = 500})}});
    run(world, 20);
    CHECK(std::fabs(world.body(raft).position().y()) < 1e-6);
    CHECK(std::fabs(world.body(raft).angle()) < 1e-6);
}

TEST_CASE("a magnet on a body is drawn as it draws", "[dynamics][fields]") {
    World world({.gravity = {0, 0}, .ledger = true});
    const BodyId iron = disc(world, {0, 0}, {0, 0}, 1), magnet = disc(world, {3, 0}, {0, 0}, 2);
    world.addField({.law = Magnet{magnet, {.strength = 5, .power = 2}}});
    run(world, 0.9);
    const Vec2 p = world.body(iron).mass() * world.body(iron).velocity() +
                   world.body(magnet).mass() * world.body(magnet).velocity();
    CHECK(world.body(iron).velocity().x() > 0.3);
    CHECK(p.norm() < 1e-13);
    const EnergyLedger& e = world.ledger().energy;
    CHECK(e.kinetic == Approx(-5.0 / 3 - e.fields).epsilon(1e-4));
}
