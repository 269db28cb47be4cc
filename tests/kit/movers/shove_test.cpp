// SPDX-License-Identifier: MIT
#include <cmath>

#include <plumb/movers/move_and_slide.h>
#include <plumb/shapes/tile_text.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

std::vector<ShapeDef> shovedHeroes() {
    return {box({0.4, 0.9}), capsule({0, -0.5}, {0, 0.5}, 0.4), roundedBox({0.3, 0.8}, 0.1)};
}

/// The ground's top is at 0, and a wall comes from the left for 10 m.
void pushedByWall(World& world, const ShapeDef& hero, double speed) {
    const BodyId wall = addKinematic(world, {-1, 2}, box({0.2, 1.9}), {speed, 0});
    SlidingMover slider{addKinematic(world, {0.2, 0.901}, hero)};
    const int ticks = static_cast<int>(10 / speed / dt);
    for (int i = 0; i < ticks; ++i) {
        slider.step(world, 0, dt);
        INFO("tick " << i << " at " << slider.slide.position.x());
        REQUIRE_FALSE(slider.slide.crushed);
        REQUIRE(world.distance({wall, 0}, {slider.body, 0}).separation > 0.9 * skin);
    }
    CHECK(slider.slide.position.x() > world.body(wall).position().x() + 0.2 + 0.4);
}

}  // namespace

TEST_CASE("a wall that comes at 1 to 7 m/s pushes a mover over 10 m of flush boxes, and does not go through it",
          "[movers]") {
    for (const ShapeDef& hero : shovedHeroes()) {
        for (double speed : {1.0, 3.0, 4.0, 7.0}) {
            World world;
            for (int i = -3; i < 20; ++i) addStatic(world, {i * 1.0, -0.5}, box({0.5, 0.5}));
            pushedByWall(world, hero, speed);
        }
    }
}

TEST_CASE("a wall pushes a mover up a slope of 11 degrees, and up tiles of 22.5 and 45 degrees", "[movers]") {
    const std::vector<std::vector<std::string>> hills = {{"................", "......12########", "################"},
                                                         {"................", "....../#########", "################"}};
    for (const ShapeDef& hero : shovedHeroes()) {
        World plain;
        addStatic(plain, {0, 0}, chain({{40, 7.6}, {2, 0}, {-10, 0}}));
        pushedByWall(plain, hero, 1);
        for (const auto& hill : hills) {
            World world;
            addStatic(world, {-4, -1}, tiles(tileMapOf(hill)));
            pushedByWall(world, hero, 2);
        }
    }
}

TEST_CASE("who lies over a flush floor and a wall is parted from the wall along the floor", "[movers]") {
    World world;
    for (int i = -3; i < 6; ++i) addStatic(world, {i * 1.0, -0.5}, box({0.5, 0.5}));
    const BodyId wall = addStatic(world, {-5, 1}, box({0.2, 1}));
    SlidingMover slider{addKinematic(world, {1, 0.901}, box({0.4, 0.9}))};
    slider.land(world);
    for (double depth : {0.05, 0.2, 0.39}) {
        world.body(wall).setPose({slider.slide.position.x() - 0.6 + depth, 1}, 0);
        slider.step(world, 0, dt);
        CHECK_FALSE(slider.slide.crushed);
        CHECK(world.distance({wall, 0}, {slider.body, 0}).separation > 0.9 * skin);
    }
    CHECK(std::fabs(slider.slide.position.y() - 0.901) < 1e-9);
}

TEST_CASE("who walks at 3 m/s into a wedge of slope and ceiling, or a wall that leans, stops and says so", "[movers]") {
    for (const bool ceiling : {true, false}) {
        World world;
        addStatic(world, {0, 0}, ceiling ? chain({{12, 6}, {2, 0}, {-10, 0}}) : chain({{10, 0}, {-10, 0}}));
        if (ceiling)
            addStatic(world, {5, 3}, box({4, 0.2}));
        else
            addStatic(world, {4, 0}, {.shape = Polygon{{{0, 0}, {4, 0}, {4, 8}}}});
        SlidingMover slider{addKinematic(world, {0, 0.901}, capsule({0, -0.5}, {0, 0.5}, 0.4))};
        for (int i = 0; i < 180; ++i) slider.step(world, 3, dt);
        INFO(ceiling << " at " << slider.slide.position.x());
        CHECK(slider.slide.isOnFloor);
        CHECK(slider.slide.isOnWall);
        CHECK(slider.slide.velocity.isZero(0));
        CHECK(slider.slide.wallNormal.x() < 0);
        CHECK(std::fabs(slider.slide.displacement.x()) < 1e-6);
    }
}

TEST_CASE("a wall against which a platform of 2 m/s carries a mover is told as a hit of 2 m/s", "[movers]") {
    World world;
    const BodyId platform = addKinematic(world, {0, 0}, box({6, 0.25}));
    const BodyId wall = addStatic(world, {3, 2}, box({0.5, 1}));
    SlidingMover slider{addKinematic(world, {0, 1.151}, box({0.4, 0.9}))};
    slider.land(world);
    world.body(platform).setVelocity({2, 0});
    int told = 0;
    for (int i = 0; i < 120; ++i) {
        for (const SlideHit& hit : slider.step(world, 0, dt).hits) {
            if (hit.shape.body != wall) continue;
            ++told;
            CHECK(hit.normal == Vec2(-1, 0));
            CHECK(std::fabs(hit.speed - 2) < 1e-9);
        }
    }
    // It comes to the wall after 2.099 m, in tick 63.
    CHECK(told == 120 - 62);
}

TEST_CASE("a mover that a platform carries into a wall, under a beam, or that a wall pushes, is on that wall",
          "[movers]") {
    for (const double side : {1.0, -1.0}) {
        World world;
        const BodyId platform = addKinematic(world, {0, 0}, box({6, 0.25}), {side * 2, 0});
        addStatic(world, {side * 3, 2}, box({0.5, 1}));
        SlidingMover slider{addKinematic(world, {0, 1.151}, box({0.4, 0.9}))};
        int onWall = 0;
        for (int i = 0; i < 180; ++i) {
            slider.step(world, 0, dt);
            // The platform is the only other thing, and it is a floor.
            CHECK(slider.slide.isOnWall == (slider.slide.position.x() * side > 2.1 - 1.01 * skin));
            if (slider.slide.isOnWall) CHECK(slider.slide.wallNormal == Vec2(-side, 0));
            onWall += slider.slide.isOnWall;
        }
        CHECK(onWall > 90);
        CHECK(slider.slide.isOnFloor);

        world.body(platform).setVelocity({0, 0});
        const BodyId pusher = addKinematic(world, {-side * 1, 2}, box({0.2, 1.5}), {side * 3, 0});
        for (int i = 0; i < 60; ++i) {
            slider.step(world, 0, dt);
            const double gap = world.distance({pusher, 0}, {slider.body, 0}).separation;
            if (gap < 1.01 * skin) break;
            CHECK_FALSE(slider.slide.isOnWall);
        }
        CHECK(slider.slide.isOnWall);
        CHECK(slider.slide.wallNormal == Vec2(side, 0));
    }
    World world;
    addKinematic(world, {0, 0}, box({2, 0.25}), {0, 2});
    addStatic(world, {0, 4}, box({2, 0.25}));
    SlidingMover slider{addKinematic(world, {0, 1.151}, box({0.4, 0.9}))};
    bool onCeiling = false;
    for (int i = 0; i < 60 && !onCeiling; ++i) onCeiling = slider.step(world, 0, dt).isOnCeiling;
    CHECK(onCeiling);
    CHECK_FALSE(slider.slide.isOnWall);
}

}  // namespace plumb::test
