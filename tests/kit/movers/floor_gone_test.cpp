// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/movers/platform_mover.h>
#include <plumb/shapes/tile_text.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

TEST_CASE("who cannot drop through, half on stone, does not fall through the one-way tiles that it then walks on",
          "[movers]") {
    for (double x : {2.9, 3.0, 3.1}) {
        World world;
        addStatic(world, {0, 0}, tiles(tileMapOf({"..........", "###=======", "..........", "##########"})));
        PlatformMover mover(addKinematic(world, {x, 3.5}, box({0.3, 0.45})));
        const auto step = [&](const PlatformInput& input, int ticks) {
            for (int i = 0; i < ticks; ++i) {
                mover.step(world, input, dt);
                world.step(dt);
            }
        };
        step({}, 20);
        step({.jump = true, .down = true}, 1);
        step({}, 10);
        CHECK(mover.slide().dropping.empty());
        step({.move = 1}, 60);
        CHECK(mover.slide().isOnFloor);
        CHECK(mover.slide().position.x() > 4);
        CHECK(std::fabs(mover.slide().position.y() - 3.451) < 1e-9);
    }
}

TEST_CASE("a floor that is set 30 m or 0.5 m away by hand does not take along who stood on it", "[movers]") {
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
        for (const Vec2& to : {Vec2(30, -0.5), Vec2(0, -1), Vec2(0, -40)}) {
            World world;
            const BodyId floor = world.add({.type = type, .position = {0, -0.5}, .shapes = {box({5, 0.5})}});
            SlidingMover slider{addKinematic(world, {0, 0.901}, box({0.4, 0.9}))};
            slider.land(world);
            for (int i = 0; i < 5; ++i) slider.step(world, 0, dt);
            world.body(floor).setPose(to, 0);
            slider.step(world, 0, dt);
            CHECK_FALSE(slider.slide.isOnFloor);
            CHECK(slider.slide.displacement.isZero(0));
            slider.step(world, 0, dt);
            CHECK(slider.slide.position.x() == 0);
            CHECK(slider.slide.displacement.y() < 0);
        }
    }
}

TEST_CASE("who stands on a platform of 5 m/s that is removed flies on at its speed", "[movers]") {
    World world;
    const BodyId platform = addKinematic(world, {0, 0}, box({2, 0.25}));
    SlidingMover slider{addKinematic(world, {0, 1.151}, box({0.4, 0.9}))};
    slider.land(world);
    world.body(platform).setVelocity({5, 2});
    for (int i = 0; i < 10; ++i) slider.step(world, 0, dt);
    world.remove(platform);
    slider.step(world, 0, dt);
    CHECK_FALSE(slider.slide.isOnFloor);
    CHECK(slider.slide.velocity == Vec2(5, 2));
    CHECK(slider.slide.platformVelocity == Vec2(5, 2));
}

}  // namespace plumb::test
