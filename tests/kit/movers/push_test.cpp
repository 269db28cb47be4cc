// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/math/trig.h>
#include <plumb/movers/move_and_slide.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr double friction = 0.4, mass = 4;

/// A mover 3 m to the left of a crate of 4 kg on a floor, friction 0.4 between the two.
struct Yard {
    World world;
    BodyId crate;
    SlidingMover slider;

    explicit Yard(double strength, double friction_ = friction) : slider{{}, {.pushStrength = strength}} {
        ShapeDef floor = box({200, 0.5}, {.friction = friction_}),
                 load = box({0.5, 0.5}, {.density = mass, .friction = friction_});
        addStatic(world, {100, -0.5}, floor);
        crate = world.add({.position = {3, 0.5}, .shapes = {load}});
        slider.body = addKinematic(world, {0, 0.95}, box({0.4, 0.9}));
        for (int i = 0; i < 60; ++i) slider.step(world, 0, dt);
    }
};

}  // namespace

TEST_CASE("a crate under a push F and friction mu m g gains (F - mu m g) / m a second, up to the mover's speed",
          "[movers]") {
    for (double strength : {20.0, 30.0, 60.0}) {
        Yard yard(strength);
        const Body crate = yard.world.body(yard.crate);
        const double law = (strength - friction * mass * g) / mass;
        while (!(crate.velocity().x() > 0)) yard.slider.step(yard.world, 6, dt);
        // From here on it is pushed in each tick.
        double before = crate.velocity().x();
        int ticks = 0;
        for (; crate.velocity().x() < 6 - 2 * strength / mass * dt; ++ticks) {
            const Slide& slide = yard.slider.step(yard.world, 6, dt);
            REQUIRE(slide.hits.size() == 1);
            CHECK(slide.hits[0].effect == SlideEffect::Pushed);
            CHECK(std::fabs(slide.hits[0].impulse - strength * dt) < 1e-12);
            // The solver's friction is soft, and in single precision: a thousandth of it.
            CHECK(std::fabs(crate.velocity().x() - before - law * dt) < 1e-3 * friction * g * dt);
            before = crate.velocity().x();
            CHECK(depthOf(yard.world, yard.slider.body, true) < 0);
            REQUIRE(ticks < 2000);
        }
        CHECK(ticks > 10);
        const double from = crate.position().x();
        for (int i = 0; i < 120; ++i) yard.slider.step(yard.world, 6, dt);
        // The push brings it to the mover's speed, of which friction takes a tick's share; a tick or two are missed.
        const double mean = (crate.position().x() - from) / (120 * dt);
        CHECK(mean < 6);
        CHECK(mean > 6 - 3 * friction * g * dt);
    }
}

TEST_CASE("a crate whose friction is more than the push stays, and so does who pushes", "[movers]") {
    Yard yard(15);  // friction 15.7 N
    for (int i = 0; i < 600; ++i) yard.slider.step(yard.world, 6, dt);
    // Contacts at rest creep: 1 mm in 10 s is left to them.
    CHECK(std::fabs(yard.world.body(yard.crate).position().x() - 3) < 1e-3);
    CHECK(yard.slider.slide.isOnWall);
    CHECK(std::fabs(yard.slider.slide.position.x() - (2.5 - 0.4 - 1e-3)) < 1e-3);
}

TEST_CASE("without strength even a feather without friction stops a mover", "[movers]") {
    Yard yard(0, 0);
    for (int i = 0; i < 120; ++i) yard.slider.step(yard.world, 6, dt);
    CHECK(std::fabs(yard.world.body(yard.crate).position().x() - 3) < 1e-4);
    CHECK(yard.slider.slide.velocity.x() == 0);
}

TEST_CASE("under and beside a mover that stands crates fall asleep", "[movers]") {
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    const BodyId under = world.add({.position = {0, 0.5}, .shapes = {box({0.5, 0.5})}});
    const BodyId beside = world.add({.position = {1.1, 0.8}, .shapes = {box({0.5, 0.8})}});
    SlidingMover slider{addKinematic(world, {0.1, 2.5}, box({0.4, 0.9}))};
    for (int i = 0; i < 300; ++i) slider.step(world, 0, dt);
    CHECK_FALSE(world.body(under).awake());
    CHECK_FALSE(world.body(beside).awake());
}

TEST_CASE("a crate on a lift carries a mover up and down, and is not pressed into the lift", "[movers]") {
    World world;
    const BodyId lift = addKinematic(world, {0, 0}, box({2, 0.25}));
    const BodyId crate = world.add({.position = {0, 0.75}, .shapes = {box({0.8, 0.5})}});
    SlidingMover slider{addKinematic(world, {0, 3}, box({0.4, 0.9}))};
    slider.land(world);
    double pressed = 0;
    for (int i = 0; i < 600; ++i) {
        // Up and down by 2 m, at up to 2 m/s: it starts and turns at 2 m/s^2, well below what makes the crate fly.
        world.body(lift).setVelocity({0, 2 * sinCos(i * dt).sin});
        slider.step(world, 0, dt);
        REQUIRE(slider.slide.isOnFloor);
        REQUIRE(slider.slide.floor->shape.body == crate);
        pressed = std::max(pressed, -world.distance({lift, 0}, {crate, 0}).separation);
        CHECK(depthOf(world, slider.body, true) < 1e-3);
    }
    // The contact's own slop is 5 mm.
    CHECK(pressed < 0.01);
}

TEST_CASE("who stands on a scale presses it with its weight", "[movers]") {
    // A plank on a spring: at rest it is down by weight / stiffness beyond its own.
    for (double weight : {0.0, 50.0}) {
        World world;
        addStatic(world, {0, -5}, box({1, 1}));
        const BodyId plank = world.add(
            {.position = {0, 0}, .fixedRotation = true, .lockX = true, .shapes = {box({2, 0.1}, {.density = 10})}});
        SlidingMover slider{addKinematic(world, {0, 2}, box({0.4, 0.9})), {.weight = weight}};
        const double stiffness = 400, damping = 150;
        double height = 0;
        for (int i = 0; i < 1200; ++i) {
            const Body body = world.body(plank);
            world.body(plank).applyForce({0, -stiffness * body.position().y() - damping * body.velocity().y()});
            slider.step(world, 0, dt);
            height = body.position().y();
        }
        CHECK(slider.slide.isOnFloor);
        INFO(weight);
        const double own = 10 * 4 * 0.2 * g;
        // Settled to a skin's share of it.
        CHECK(std::fabs(height + (own + weight) / stiffness) < 2e-3);
    }
}

}  // namespace plumb::test
