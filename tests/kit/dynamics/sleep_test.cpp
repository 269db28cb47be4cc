// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <plumb/plumb.h>

#include "catch.h"
#include "kit/dynamics/worlds.h"

namespace plumb::test {

using Catch::Matchers::WithinRel;

TEST_CASE("a crate on a belt of 0.001 to 0.05 m/s is carried on for 10 s", "[dynamics][sleep]") {
    for (const double speed : {0.001, 0.01, 0.04, 0.05}) {
        World world;
        world.add({.type = BodyType::Static, .shapes = {box({50, 0.5}, {.friction = 1, .surfaceSpeed = speed})}});
        const BodyId crate = world.add({.position = {0, 1}, .shapes = {box({0.5, 0.5}, {.friction = 1})}});
        run(world, 10);
        INFO("belt of " << speed << " m/s");
        CHECK_THAT(world.body(crate).position().x(), WithinRel(10 * speed, 0.03));  // the start takes a few steps
    }
}

TEST_CASE("crates sleep soon after the one that kept them awake has gone, though it stays restless",
          "[dynamics][sleep]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({50, 0.5})}});
    std::vector<BodyId> row;
    for (int i = 0; i < 12; ++i) row.push_back(world.add({.position = {1.0 * i, 1}, .shapes = {box({0.5, 0.5})}}));
    const BodyId restless = world.add({.position = {6, 2}, .shapes = {box({0.5, 0.5})}});
    const auto shake = [&](double time) {
        for (int tick = 0; tick < time / dt; ++tick) {
            world.body(restless).setVelocity({tick % 2 == 0 ? 0.2 : -0.2, world.body(restless).velocity().y()});
            world.step(dt);
        }
    };
    shake(3);
    for (const BodyId crate : row) CHECK(world.body(crate).awake());
    world.body(restless).setPose({30, 1}, 0);
    shake(1.5);  // the time to fall asleep, and as long again until the row is looked at
    for (const BodyId crate : row) CHECK_FALSE(world.body(crate).awake());
}

TEST_CASE("a crate that a slow belt presses against a wall sleeps", "[dynamics][sleep]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {box({50, 0.5}, {.friction = 0.5, .surfaceSpeed = 0.04})}});
    world.add({.type = BodyType::Static, .position = {1.5, 1}, .shapes = {box({0.5, 0.5}, {.friction = 0})}});
    const BodyId crate = world.add({.position = {0.5, 1}, .shapes = {box({0.5, 0.5}, {.friction = 0.5})}});
    run(world, 3);
    CHECK_FALSE(world.body(crate).awake());
}

TEST_CASE("a hinge, a slide and an actuator with slow motors run on for 10 s", "[dynamics][sleep]") {
    for (const double speed : {0.001, 0.01, 0.04, -0.04}) {
        World world;
        const BodyId ground = world.add({.type = BodyType::Static});
        const BodyId arm = world.add({.position = {0.5, 0}, .shapes = {box({0.5, 0.1})}});
        const BodyId slide = world.add({.position = {0, 10}, .shapes = {box({0.5, 0.1})}});
        const BodyId held = world.add({.position = {0, 20}, .shapes = {box({0.5, 0.1})}});
        world.join(RevoluteJointDef{.bodyA = ground, .bodyB = arm, .motorSpeed = speed, .maxMotorTorque = 1e6});
        world.join(PrismaticJointDef{
            .bodyA = ground, .bodyB = slide, .anchor = {0, 10}, .motorSpeed = speed, .maxMotorForce = 1e6});
        world.join(MotorJointDef{
            .bodyA = ground, .bodyB = held, .rate = 0, .velocity = {speed, 0}, .maxForce = 1e6, .maxTorque = 1e6});
        run(world, 10);
        INFO("motors of " << speed << " m/s or rad/s");
        CHECK_THAT(world.body(arm).angle(), WithinRel(10 * speed, 0.02));
        CHECK_THAT(world.body(slide).position().x(), WithinRel(10 * speed, 0.02));
        CHECK_THAT(world.body(held).position().x(), WithinRel(10 * speed, 0.02));
    }
}

TEST_CASE("a pendulum of 1 m that swings by 5 mm to 5 cm swings on for a minute", "[dynamics][sleep]") {
    for (const double swing : {0.005, 0.01, 0.02, 0.05}) {
        World world;
        const BodyId ground = world.add({.type = BodyType::Static});
        const Vec2 at(std::sin(swing), -std::cos(swing));
        const BodyId bob = world.add({.position = at, .fixedRotation = true, .shapes = {circle(0.1)}});
        world.join(DistanceJointDef{.bodyA = ground, .bodyB = bob, .anchorA = {0, 0}, .anchorB = at});
        int turns = 0;
        double before = at.x();
        for (int tick = 0; tick < 3600; ++tick) {
            world.step(dt);
            const double x = world.body(bob).position().x();
            turns += x * before < 0 ? 1 : 0;
            before = x;
        }
        INFO("swing of " << swing << " m");
        // sqrt(9.81) * 60 / pi = 59.8 half swings
        CHECK(turns >= 59);
        CHECK(turns <= 60);
    }
}

TEST_CASE("a box that begins to slide slowly slides on, however long the step", "[dynamics][sleep]") {
    for (const double length : {0.1, 0.25, 0.5, 0.75, 1.0}) {
        const double steep = std::atan(0.5) + 0.1 * std::numbers::pi / 180, g = 9.81;
        World world({.gravity = {g * std::sin(steep), -g * std::cos(steep)}});
        world.add({.type = BodyType::Static, .shapes = {box({5000, 1}, {.friction = 0.5})}});
        const BodyId crate = world.add({.position = {0, 1.25}, .shapes = {box({0.5, 0.25}, {.friction = 0.5})}});
        for (double time = 0; time < 10; time += length) world.step(length);
        INFO("steps of " << length << " s");
        CHECK(world.body(crate).awake());
    }
}

TEST_CASE("a stone that stops in the air when a step ends flies on, however long the step", "[dynamics][sleep]") {
    const double gravity = 9.81;
    for (const double length : {1.0 / 60, 0.1, 0.25, 0.5, 0.75, 1.0}) {
        for (const double sleepTime : {0.02, 0.5, 2.0}) {
            World world({.gravity = {0, -gravity}, .solver = {.sleepTime = sleepTime}});
            const BodyId stone = world.add({.velocity = {0, gravity * length}, .shapes = {circle(0.5)}});
            world.step(length);
            REQUIRE(world.body(stone).velocity().norm() < 1e-12);
            world.step(length);
            INFO("steps of " << length << " s, sleepTime " << sleepTime);
            CHECK(world.body(stone).awake());
            CHECK_THAT(world.body(stone).velocity().y(), WithinRel(-gravity * length, 1e-9));
        }
    }
}

TEST_CASE("a box on a slope half a degree over its friction angle slides on", "[dynamics][sleep]") {
    for (const double degrees : {0.1, 0.5, 2.0}) {
        const double steep = std::atan(0.5) + degrees * std::numbers::pi / 180, g = 9.81;
        World world({.gravity = {g * std::sin(steep), -g * std::cos(steep)}});
        world.add({.type = BodyType::Static, .shapes = {box({5000, 1}, {.friction = 0.5})}});
        const BodyId crate = world.add({.position = {0, 1.25}, .shapes = {box({0.5, 0.25}, {.friction = 0.5})}});
        run(world, 10);
        const double way = 50 * g * (std::sin(steep) - 0.5 * std::cos(steep));
        INFO(degrees << " degrees over");
        CHECK_THAT(world.body(crate).position().x(), WithinRel(way, 0.05));
    }
}

TEST_CASE("a pit of capsules falls asleep, although some are near without touching", "[dynamics][sleep][slow]") {
    World world({.gravity = {0, -10}});
    world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({30, 1})}});
    for (const double x : {-5.0, 5.0})
        world.add({.type = BodyType::Static, .position = {x, 5}, .shapes = {box({0.5, 6})}});
    for (int i = 0; i < 120; ++i)
        world.add({.position = {-4 + (i % 15) * 0.57 + 0.02 * (i % 7), 0.5 + (i / 15) * 0.6},
                   .shapes = {{.shape = Capsule{{-0.15, 0}, {0.15, 0}, 0.1}}}});
    run(world, 20);
    CHECK(world.counts().awakeBodies == 0);
}

}  // namespace plumb::test
