// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/math/trig.h>
#include <plumb/movers/move_and_slide.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

std::vector<ShapeDef> ridingHeroes() {
    return {box({0.4, 0.9}), capsule({0, -0.5}, {0, 0.5}, 0.4), circle(0.5)};
}

}  // namespace

TEST_CASE("for 10,000 ticks on a platform that accelerates and turns nothing slips: 1e-9 m along it", "[movers]") {
    for (const ShapeDef& hero : ridingHeroes()) {
        World world;
        const BodyId platform = addKinematic(world, {0, 0}, box({3, 0.25}));
        SlidingMover slider{addKinematic(world, {1, 2}, hero)};
        slider.land(world);
        const Vec2 start = slider.slide.position;
        double worst = 0, widest = 0;
        for (int tick = 1; tick <= 10000; ++tick) {
            const double t = tick * dt;
            world.body(platform).moveTo({8 * sinCos(0.9 * t).sin, 3 * sinCos(1.3 * t).sin}, 0.5 * sinCos(0.7 * t).sin,
                                        dt);
            slider.step(world, 0, dt);
            REQUIRE(slider.slide.isOnFloor);
            // Its place is a function of the platform's alone. So, whenever that comes back, it does.
            const double off = slider.slide.position.y() - world.body(platform).position().y();
            widest = std::max(widest, std::fabs(off));
            REQUIRE(depthOf(world, slider.body) < 0);
            if (tick % 500 != 0) continue;
            World back = world;
            SlidingMover there = slider;
            back.body(platform).moveTo({0, 0}, 0, dt);
            there.step(back, 0, dt);
            worst = std::max(worst, (there.slide.position - start).cwiseAbs().maxCoeff());
        }
        INFO("worst " << worst);
        CHECK(worst < 1e-9);
        CHECK(widest < 3);
    }
}

TEST_CASE("walking to and fro on a moving, turning platform ends where it would on one at rest", "[movers]") {
    const auto walk = [](bool moves) {
        World world;
        const BodyId platform = addKinematic(world, {0, 0}, box({8, 0.25}));
        SlidingMover slider{addKinematic(world, {1, 2}, box({0.4, 0.9}))};
        slider.land(world);
        for (int tick = 1; tick <= 6000; ++tick) {
            const double t = tick * dt;
            if (moves) world.body(platform).moveTo({9 * sinCos(0.8 * t).sin, 4 * sinCos(1.1 * t).sin}, 0, dt);
            slider.step(world, tick % 120 < 60 ? 2 : -2, dt);
            REQUIRE(slider.slide.isOnFloor);
        }
        return Vec2(slider.slide.position - world.body(platform).position());
    };
    // 6,000 roundings of 10 m, 1.8e-15 each.
    CHECK((walk(true) - walk(false)).cwiseAbs().maxCoeff() < 2e-11);
}

TEST_CASE("a lift at 20 m/s carries up, stops, and carries down faster than a fall", "[movers]") {
    World world;
    const BodyId lift = addKinematic(world, {0, 0}, box({2, 0.25}));
    SlidingMover slider{addKinematic(world, {0, 2}, box({0.4, 0.9}))};
    slider.land(world);
    for (double speed : {20.0, 0.0, -20.0, 5.0, -40.0}) {
        world.body(lift).setVelocity({0, speed});
        for (int i = 0; i < 30; ++i) {
            slider.step(world, 0, dt);
            REQUIRE(slider.slide.isOnFloor);
            CHECK(slider.slide.platformVelocity.y() == speed);
            CHECK(std::fabs(world.distance({lift, 0}, {slider.body, 0}).separation - 1e-3) < 1e-12);
        }
    }
}

TEST_CASE("who leaves a platform has its speed, its upward speed or none, as is wished", "[movers]") {
    const Vec2 platformSpeed(5, -2);
    for (const auto& [leave, gained] : {std::pair(PlatformOnLeave::AddVelocity, Vec2(5, -2)),
                                        {PlatformOnLeave::AddUpwardVelocity, Vec2(5, 0)},
                                        {PlatformOnLeave::DoNothing, Vec2(0, 0)}}) {
        World world;
        const BodyId platform = addKinematic(world, {0, 0}, box({3, 0.25}));
        SlidingMover slider{addKinematic(world, {0, 1.3}, box({0.4, 0.9})), {.platformOnLeave = leave}};
        slider.land(world);
        world.body(platform).setVelocity(platformSpeed);
        for (int i = 0; i < 10; ++i) slider.step(world, 0, dt);
        const Slide slide =
            moveAndSlide(world, slider.body, {.velocity = {1, 6}, .dt = dt}, slider.settings, slider.slide);
        CHECK_FALSE(slide.isOnFloor);
        CHECK((slide.velocity - Vec2(1, 6) - gained).cwiseAbs().maxCoeff() < 1e-12);
    }
}

TEST_CASE("who lands on a running platform at its speed stands still on it", "[movers]") {
    World world;
    addKinematic(world, {0, 0}, box({30, 0.25}), {7, 0});
    SlidingMover slider{addKinematic(world, {0, 3}, box({0.4, 0.9}))};
    slider.slide.velocity = {7, 0};
    while (!slider.slide.isOnFloor) slider.step(world, 7, dt);
    CHECK(slider.slide.velocity.cwiseAbs().maxCoeff() < 1e-12);
    CHECK(slider.slide.platformVelocity == Vec2(7, 0));
}

TEST_CASE("a wall that comes at 3 m/s, or at 300, pushes a mover along, a skin ahead", "[movers]") {
    for (const ShapeDef& hero : ridingHeroes()) {
        for (double speed : {3.0, 300.0}) {
            World world;
            addStatic(world, {0, -0.5}, box({1000, 0.5}));
            const BodyId wall = addKinematic(world, {-0.61, 1}, box({0.1, 1}));
            SlidingMover slider{addKinematic(world, {0, 1}, hero), {.reach = 5}};
            slider.land(world);
            world.body(wall).setVelocity({speed, 0});
            for (int i = 0; i < 120; ++i) {
                slider.step(world, 0, dt);
                if (i < 4) continue;  // it is not there yet
                REQUIRE_FALSE(slider.slide.crushed);
                REQUIRE(std::fabs(world.distance({wall, 0}, {slider.body, 0}).separation - 1e-3) < 1e-9);
            }
            CHECK(slider.slide.isOnFloor);
        }
    }
}

TEST_CASE("between a wall that comes and one that stays, and under a press, crushed is said, not before", "[movers]") {
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    addStatic(world, {3, 1}, box({0.5, 1}));
    const BodyId press = addKinematic(world, {-3, 1}, box({0.5, 1}), {1, 0});
    SlidingMover slider{addKinematic(world, {0, 0.95}, box({0.4, 0.9}))};
    slider.land(world);
    bool crushed = false;
    for (int i = 0; i < 600 && !crushed; ++i) {
        crushed = slider.step(world, 0, dt).crushed;
        const double gap = 2.5 - (world.body(press).position().x() + 0.5) - 0.8;
        CHECK(crushed == (gap < skin));
    }
    CHECK(crushed);

    World under;
    addStatic(under, {0, -0.5}, box({20, 0.5}));
    const BodyId hammer = addKinematic(under, {0, 4}, box({0.5, 0.5}), {0, -2});
    SlidingMover below{addKinematic(under, {0, 0.95}, box({0.4, 0.9}))};
    bool flat = false;
    for (int i = 0; i < 600 && !flat; ++i) {
        flat = below.step(under, 0, dt).crushed;
        CHECK(flat == (under.body(hammer).position().y() - 0.5 < 1.8 + skin));
    }
    CHECK(flat);
    // What crushed it goes away: it is free again.
    under.body(hammer).setVelocity({0, 2});
    for (int i = 0; i < 60; ++i) below.step(under, 1, dt);
    CHECK_FALSE(below.slide.crushed);
    CHECK(below.slide.isOnFloor);
    CHECK(below.slide.position.x() > 0.9);
}

TEST_CASE("a crate carries who stands on it, and is not pressed into the ground where it falls", "[movers]") {
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    const BodyId crate = world.add({.position = {0, 6}, .shapes = {box({1, 0.5})}});
    SlidingMover slider{addKinematic(world, {0, 8}, box({0.4, 0.9}))};
    double lowest = 1;
    for (int i = 0; i < 240; ++i) {
        slider.step(world, 0, dt);
        lowest = std::min(lowest, world.body(crate).position().y());
    }
    CHECK(slider.slide.isOnFloor);
    CHECK(slider.slide.floor->shape.body == crate);
    CHECK(std::fabs(slider.slide.position.y() - 1.9) < 0.01);
    // As deep as it would fall in by itself: at 10.4 m/s the solver stops it within a linear slop or two.
    CHECK(lowest > 0.5 - 0.02);
    world.body(crate).setVelocity({3, 0});
    const double at = slider.slide.position.x() - world.body(crate).position().x();
    for (int i = 0; i < 60; ++i) slider.step(world, 0, dt);
    CHECK(std::fabs(slider.slide.position.x() - world.body(crate).position().x() - at) < 0.01);
}

TEST_CASE("a copy of the world and of what came of the last tick goes on to the same bits", "[movers]") {
    World world;
    const BodyId platform = addKinematic(world, {0, 0}, box({3, 0.25}));
    SlidingMover slider{addKinematic(world, {1, 2}, capsule({0, -0.5}, {0, 0.5}, 0.4))};
    const auto tick = [&](World& w, SlidingMover& s, int i) {
        w.body(platform).moveTo({sinCos(0.05 * i).sin, 0}, 0.3 * sinCos(0.03 * i).sin, dt);
        s.step(w, i % 50 < 25 ? 1 : -1, dt);
    };
    for (int i = 0; i < 200; ++i) tick(world, slider, i);
    World copy = world;
    SlidingMover other = slider;
    for (int i = 200; i < 400; ++i) {
        tick(world, slider, i);
        tick(copy, other, i);
        REQUIRE(slider.slide.position == other.slide.position);
    }
}

}  // namespace plumb::test
