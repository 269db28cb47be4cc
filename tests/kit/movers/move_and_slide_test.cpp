// SPDX-License-Identifier: MIT
#include <plumb/movers/move_and_slide.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

TEST_CASE("at 1,000 m/s a mover stops a skin short of a wall of 1 cm, from either side", "[movers]") {
    for (const ShapeDef& hero : heroes()) {
        for (double side : {1.0, -1.0}) {
            World world;
            const BodyId wall = addStatic(world, {side * 9, 0}, box({0.005, 3}));
            const BodyId body = addKinematic(world, {0, 0}, hero);
            Slide slide = moveAndSlide(world, body, {.velocity = {side * 1000, 0}, .dt = dt});
            world.step(dt);
            CHECK(slide.isOnWall);
            CHECK(slide.velocity.x() == 0);
            REQUIRE(slide.hits.size() == 1);
            CHECK(slide.hits[0].shape == ShapeId{wall, 0});
            CHECK(slide.hits[0].normal.x() == -side);
            CHECK(slide.hits[0].speed == 1000);
            // In double, some roundings of 10 m.
            CHECK(std::fabs(world.distance({wall, 0}, {body, 0}).separation - skin) < 1e-13);
        }
    }
}

TEST_CASE("100,000 shots at 1,000 m/s into a closed room of 1 cm walls stay within, never nearer than half a skin",
          "[movers]") {
    Random random(5);
    const std::vector<ShapeDef> shapes = heroes();
    for (int i = 0; i < cases(100); ++i) {
        World world;
        const double turn = random.uniform(-3, 3);
        const BodyId room = world.add({.type = BodyType::Static,
                                       .angle = turn,
                                       .shapes = {{.shape = boxPolygon({0.005, 4}, {4, 0})},
                                                  {.shape = boxPolygon({0.005, 4}, {-4, 0})},
                                                  {.shape = boxPolygon({4, 0.005}, {0, 4})},
                                                  {.shape = boxPolygon({4, 0.005}, {0, -4})}}});
        const BodyId body = addKinematic(world, {0, 0}, shapes[static_cast<std::size_t>(i) % shapes.size()]);
        Slide slide;
        double nearest = 1;
        for (int shot = 0; shot < 1000; ++shot) {
            const double angle = random.uniform(-4, 4), speed = random.uniform(0, 1) < 0.5 ? 1000 : 1;
            const SinCos way = sinCos(angle);
            slide = moveAndSlide(world, body, {.velocity = Vec2(way.cos, way.sin) * speed, .dt = dt}, {}, slide);
            world.step(dt);
            for (std::uint32_t wall = 0; wall < 4; ++wall)
                nearest = std::min(nearest, world.distance({room, wall}, {body, 0}).separation);
        }
        // Round shapes follow a wall's corner only by its tangent there; a skin is left of it at every stop.
        CHECK(nearest > skin / 2);
        CHECK(world.body(body).position().cwiseAbs().maxCoeff() < 4 * std::sqrt(2.0));
    }
}

TEST_CASE("sliding over 200 flush boxes, or along 200 collinear links, no way is lost, at any slant", "[movers]") {
    Random random(7);
    for (const ShapeDef& hero : heroes()) {
        for (int i = 0; i < 10; ++i) {
            World world;
            const double slant = i == 0 ? 0 : random.uniform(-0.7, 0.7);
            const Rot turned = Rot::fromAngle(slant);
            if (i % 2 == 0) {
                for (int k = -5; k < 195; ++k) addStatic(world, turned * Vec2(k, -0.5), box({0.5, 0.5}), slant);
            } else {
                std::vector<Vec2> points;
                for (int k = 195; k > -6; --k) points.push_back(turned * Vec2(k, 0));
                addStatic(world, {0, 0}, chain(points));
            }
            SlidingMover slider{addKinematic(world, turned * Vec2(0, 0) + Vec2(0, 2), hero)};
            slider.land(world);
            const Vec2 start = slider.slide.position;
            for (int tick = 0; tick < 1000; ++tick) {
                slider.step(world, 10, dt);
                if (!slider.slide.isOnFloor || slider.slide.velocity.x() != 10)
                    FAIL("tick " << tick << " at slant " << slant);
            }
            // 1,000 ticks of 10 / 60 m; some roundings of 200 m each.
            const double lost = 1000 * 10 * dt - (slider.slide.position - start).dot(turned * Vec2(1, 0));
            CHECK(std::fabs(lost) < 1e-9);
        }
    }
}

TEST_CASE("falling along a wall of 100 flush boxes, pressed against it, no height is lost", "[movers]") {
    for (const ShapeDef& hero : heroes()) {
        World world;
        for (int k = 0; k < 100; ++k) addStatic(world, {1, -k - 0.5}, box({0.5, 0.5}));
        SlidingMover slider{addKinematic(world, {-0.5, -1}, hero)};
        double height = -1, speed = 0;
        for (int tick = 0; tick < 200; ++tick) {
            slider.step(world, 3, dt);
            speed -= 9.81 * dt;
            height += speed * dt;
        }
        CHECK(slider.slide.isOnWall);
        // Where two boxes join, a round one's normal is known to the square root of a rounding, 1.5e-8, of 3 m/s.
        CHECK(std::fabs(slider.slide.position.y() - height) < 1e-7);
    }
}

TEST_CASE("a one-way slab lets a jump through from below, holds it, and lets it drop", "[movers]") {
    for (const ShapeDef& hero : heroes()) {
        for (const ShapeDef& made :
             {box({3, 0.1}), segment({-3, 0.1}, {3, 0.1}), chain({{-3, 0.1}, {0, 0.1}, {3, 0.1}})}) {
            World world;
            ShapeDef slab = made;
            slab.oneWay = Vec2(0, 1);
            const BodyId platform = addStatic(world, {0, 0}, slab);
            addStatic(world, {0, -3}, box({3, 0.1}));
            SlidingMover slider{addKinematic(world, {0, -1.8}, hero)};
            slider.slide.velocity = {0, 9};
            double highest = -10;
            for (int i = 0; i < 120; ++i) {
                slider.step(world, 0, dt);
                highest = std::max(highest, slider.slide.position.y());
            }
            // As without it: -1.8 + 9^2 / 2 g less half a tick's share.
            CHECK(std::fabs(highest - (-1.8 + 81 / (2 * 9.81) - 4.5 * dt)) < 0.01);
            REQUIRE(slider.slide.isOnFloor);
            CHECK(slider.slide.floor->shape == ShapeId{platform, 0});
            CHECK(std::fabs(world.distance({platform, 0}, {slider.body, 0}).separation - skin) < 1e-9);
            for (double hz : {60.0, 240.0}) {
                World below = world;
                SlidingMover faller = slider;
                faller.slide = moveAndSlide(
                    below, faller.body, {.velocity = {0, -0.01}, .dt = 1 / hz, .dropThrough = true}, {}, faller.slide);
                below.step(1 / hz);
                for (int i = 0; i < hz; ++i) faller.step(below, 0, 1 / hz);
                CHECK(faller.slide.isOnFloor);
                CHECK(faller.slide.position.y() < -1);
            }
        }
    }
}

TEST_CASE("who begins in a wall is put out of it by the shortest way", "[movers]") {
    for (const ShapeDef& hero : heroes()) {
        World world;
        addStatic(world, {0, 0}, box({2, 2}));
        const BodyId body = addKinematic(world, {2.2, 0.3}, hero);
        const Slide slide = moveAndSlide(world, body, {.dt = dt});
        world.step(dt);
        CHECK_FALSE(slide.crushed);
        CHECK(std::fabs(depthOf(world, body) + skin) < 1e-9);
        CHECK(slide.displacement.y() == 0);
        REQUIRE(slide.hits.size() == 1);
        CHECK(slide.hits[0].effect == SlideEffect::PushedBy);
    }
}

TEST_CASE("between two walls that lean apart, each too steep, it stands as on a floor", "[movers]") {
    World world;
    addStatic(world, {0, 0}, chain({{3, 6}, {0, 0}, {-3, 6}}));
    SlidingMover slider{addKinematic(world, {0.2, 5}, circle(0.5))};
    slider.land(world);
    CHECK(slider.slide.isOnFloor);
    CHECK(slider.slide.floorNormal == Vec2(0, 1));
    const Vec2 at = slider.slide.position;
    for (int i = 0; i < 60; ++i) slider.step(world, 0, dt);
    CHECK((slider.slide.position - at).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("a wall that leans back at 60 degrees does not lift who flies level into it", "[movers]") {
    World world;
    addStatic(world, {0, 0}, chain({{6, 10.392304845413264}, {0, 0}, {-6, -10.392304845413264}}));
    const BodyId body = addKinematic(world, {-3, 3}, circle(0.5));
    Slide slide;
    for (int i = 0; i < 60; ++i) {
        slide = moveAndSlide(world, body, {.velocity = {8, 0}, .dt = dt}, {}, slide);
        world.step(dt);
        CHECK(slide.position.y() == 3);
    }
    CHECK(slide.isOnWall);
}

TEST_CASE("a jump whose apex leaves the feet within a one-way slab falls back out of it", "[movers]") {
    World world;
    ShapeDef slab = box({3, 0.1});
    slab.oneWay = Vec2(0, 1);
    addStatic(world, {0, 0}, slab);
    addStatic(world, {0, -3}, box({3, 0.1}));
    for (double feet : {0.05, 0.09, 0.0999}) {
        SlidingMover slider{addKinematic(world, {0, feet + 0.9}, box({0.4, 0.9}))};
        for (int i = 0; i < 90; ++i) slider.step(world, 0, dt);
        CHECK(slider.slide.isOnFloor);
        CHECK(std::fabs(slider.slide.position.y() - (-2.9 + 0.9 + skin)) < 1e-9);
        world.remove(slider.body);
    }
}

TEST_CASE("a floor that is removed or moved away by hand lets it fall, and a jump by hand is taken as it is",
          "[movers]") {
    World world;
    const BodyId floor = addStatic(world, {0, -0.5}, box({5, 0.5}));
    SlidingMover slider{addKinematic(world, {0, 1}, box({0.4, 0.9}))};
    slider.land(world);
    world.body(slider.body).setPose({2, 0.901}, 0);
    slider.step(world, 0, dt);
    CHECK(slider.slide.isOnFloor);
    CHECK(std::fabs(slider.slide.position.x() - 2) < 1e-12);
    world.remove(floor);
    slider.step(world, 0, dt);
    CHECK_FALSE(slider.slide.isOnFloor);
    slider.step(world, 0, dt);
    CHECK(slider.slide.position.y() < 0.901);
}

TEST_CASE("what cannot be moved as asked is refused, by name", "[movers]") {
    World world;
    const BodyId body = addKinematic(world, {0, 0}, circle(0.5));
    const BodyId crate = world.add({.shapes = {box({1, 1})}});
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto complaint = [&](BodyId id, const SlideMotion& motion, const SlideSettings& settings) {
        try {
            moveAndSlide(world, id, motion, settings);
        } catch (const std::invalid_argument& refused) {
            return std::string(refused.what());
        }
        return std::string("nothing");
    };
    CHECK_THAT(complaint(crate, {.dt = dt}, {}), containsText("not kinematic"));
    CHECK_THAT(complaint({}, {.dt = dt}, {}), containsText("BodyId"));
    CHECK_THAT(complaint(body, {.velocity = {inf, 0}, .dt = dt}, {}), containsText("SlideMotion.velocity"));
    CHECK_THAT(complaint(body, {.dt = 0}, {}), containsText("SlideMotion.dt"));
    CHECK_THAT(complaint(body, {.dt = dt}, {.up = {0, 0}}), containsText("SlideSettings.up"));
    CHECK_THAT(complaint(body, {.dt = dt}, {.maxFloorAngle = 1.6}), containsText("SlideSettings.maxFloorAngle"));
    CHECK_THAT(complaint(body, {.dt = dt}, {.stepHeight = -1}), containsText("SlideSettings.stepHeight"));
    CHECK_THAT(complaint(body, {.dt = dt}, {.pushStrength = -1}), containsText("SlideSettings.pushStrength"));
    CHECK_THAT(complaint(body, {.dt = dt}, {.skin = 0}), containsText("SlideSettings.skin"));
    CHECK(complaint(body, {.dt = dt}, {}) == "nothing");
}

}  // namespace plumb::test
