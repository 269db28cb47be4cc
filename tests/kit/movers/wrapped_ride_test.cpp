// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/math/trig.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/shapes/tile_text.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr double roundLength = 20;

World wrapped() {
    return World({.gravity = {0, 0}, .wrap = {.width = roundLength}});
}

/// Of a rider on a platform, in the platform's frame.
Vec2 placeOn(const World& world, BodyId platform, BodyId rider) {
    const Vec2 way = world.wrap().shortest(world.body(platform).position(), world.body(rider).position());
    return world.body(platform).pose().rotation.inverse() * way;
}

}  // namespace

TEST_CASE("for 10,000 ticks riding round and round a world of 20 m, straight on, a rider slips by less than 1e-9 m",
          "[movers][slow]") {
    for (double speed : {3.0, -7.0, 130.0}) {
        for (double off : {0.0, 1.2, -1.9}) {
            World world = wrapped();
            const BodyId platform = addKinematic(world, {14, 0}, box({2, 0.25}));
            SlidingMover slider{addKinematic(world, {14 + off, 0.25 + 0.901}, box({0.4, 0.9}))};
            slider.land(world);
            const Vec2 first = placeOn(world, platform, slider.body);
            world.body(platform).setVelocity({speed, 0});
            for (int i = 0; i < 10000; ++i) {
                slider.step(world, 0, dt);
                INFO("tick " << i << " speed " << speed << " off " << off);
                REQUIRE((placeOn(world, platform, slider.body) - first).cwiseAbs().maxCoeff() < 1e-9);
                REQUIRE(std::fabs(slider.slide.displacement.x() - speed * dt) < 1e-9);
                REQUIRE(slider.slide.isOnFloor);
            }
        }
    }
}

TEST_CASE("riding a platform that turns round a world of 20 m is the same as without the seam, for 10,000 ticks",
          "[movers]") {
    World round = wrapped(), open({.gravity = {0, 0}});
    struct Ride {
        World& world;
        BodyId platform;
        SlidingMover slider;
    };
    const auto start = [](World& world) {
        const BodyId platform = addKinematic(world, {14, 0}, box({3, 0.25}));
        return Ride{world, platform, {addKinematic(world, {15, 0.25 + 0.901}, capsule({0, -0.5}, {0, 0.5}, 0.4))}};
    };
    Ride a = start(round), b = start(open);
    for (int i = 0; i < 10000; ++i) {
        // To and fro over the seam: a place far off would be rounded otherwise.
        const Vec2 velocity(9 * sinCos(0.9 * i * dt).cos, 2 * sinCos(1.3 * i * dt).cos);
        for (Ride* ride : {&a, &b}) {
            ride->world.body(ride->platform).setVelocity(velocity);
            ride->world.body(ride->platform).setAngularVelocity(0.3 * sinCos(0.7 * i * dt).cos);
            ride->slider.step(ride->world, 0, dt);
        }
        INFO("tick " << i);
        REQUIRE(a.slider.slide.isOnFloor);
        const Vec2 off = placeOn(round, a.platform, a.slider.body) - placeOn(open, b.platform, b.slider.body);
        REQUIRE(off.cwiseAbs().maxCoeff() < 1e-9);
        REQUIRE((a.slider.slide.platformVelocity - b.slider.slide.platformVelocity).cwiseAbs().maxCoeff() < 1e-9);
    }
}

TEST_CASE("a platform mover that walks ten times round a tile map of 20 m goes at one speed and keeps its height",
          "[movers]") {
    for (double move : {1.0, -1.0}) {
        World world({.wrap = {.width = roundLength}});
        TileMap map({.columns = 20, .rows = 1});
        for (int i = 0; i < 20; ++i) map.set({i, 0}, {.form = TileForm::Full});
        addStatic(world, {0, -1}, tiles(map));
        PlatformMover mover(addKinematic(world, {10, 0.901}, box({0.4, 0.9})));
        double gone = 0;
        for (int i = 0; std::fabs(gone) < 10 * roundLength; ++i) {
            const double shift = mover.step(world, {.move = move}, dt).displacement.x();
            world.step(dt);
            gone += shift;
            INFO("tick " << i << " at " << world.body(mover.body()).position().x());
            REQUIRE(mover.slide().isOnFloor);
            REQUIRE_FALSE(mover.slide().isOnWall);
            REQUIRE(std::fabs(world.body(mover.body()).position().y() - 0.901) < 1e-9);
            if (i > 60) REQUIRE(std::fabs(shift - 4 * dt * move) < 1e-9);
        }
    }
}

TEST_CASE("a wall right behind the seam stops a skin before it", "[movers]") {
    for (double side : {1.0, -1.0}) {
        World world({.wrap = {.width = roundLength}});
        addStatic(world, {10, -0.5}, box({10, 0.5}));
        addStatic(world, {side > 0 ? 0.7 : 19.3, 1}, box({0.5, 1}));
        SlidingMover slider{addKinematic(world, {10, 0.901}, box({0.4, 0.9}))};
        for (int i = 0; i < 300; ++i) slider.step(world, side * 4, dt);
        CHECK(slider.slide.isOnWall);
        CHECK(slider.slide.isOnFloor);
        const double x = world.body(slider.body).position().x();
        CHECK(std::fabs(x - (side > 0 ? 19.8 - 1e-3 : 0.2 + 1e-3)) < 1e-9);
    }
}

TEST_CASE("a wall that comes over the seam pushes a mover round and round, a skin ahead", "[movers]") {
    World world({.wrap = {.width = roundLength}});
    addStatic(world, {10, -0.5}, box({10, 0.5}));
    const BodyId wall = addKinematic(world, {17, 1}, box({0.1, 0.95}), {5, 0});
    SlidingMover slider{addKinematic(world, {18, 0.901}, box({0.4, 0.9}))};
    for (int i = 0; i < 2000; ++i) {
        slider.step(world, 0, dt);
        REQUIRE_FALSE(slider.slide.crushed);
        if (i > 30) REQUIRE(std::fabs(placeOn(world, wall, slider.body).x() - 0.501) < 1e-6);
    }
}

}  // namespace plumb::test
