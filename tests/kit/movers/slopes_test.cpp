// SPDX-License-Identifier: MIT
// Up, over and down.
#include <plumb/movers/move_and_slide.h>

#include <cmath>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

TEST_CASE("a box goes up, over and down a hill at 4 m/s along the ground, on the floor in every tick", "[movers]") {
    World world;
    addStatic(world, {0, 0}, chain({{60, 0}, {20, 0}, {16, 3}, {12, 3}, {8, 0}, {-10, 0}}));
    SlidingMover slider{addKinematic(world, {0, 0.95}, box({0.4, 0.9}))};
    slider.land(world);
    const double start = slider.slide.position.x();
    const int ticks = 400;
    int corners = 0;
    for (int tick = 0; tick < ticks; ++tick) {
        slider.step(world, 4, dt);
        REQUIRE(slider.slide.isOnFloor);
        REQUIRE(slider.slide.velocity.x() == 4);
        const double short_ = 4 * dt - slider.slide.displacement.norm();
        REQUIRE(short_ > -skin);
        corners += std::fabs(short_) > 1e-9;
    }
    // The box meets the hill's foot with its leading lower corner, leaves its top with the trailing one. At each of the
    // four corners of that way the tick's two stretches are further than its ends are apart; a second tick may be told
    // of the same corner, as a skin's offset is round there.
    CHECK(corners <= 8);
    const double slope = 5, foot = 8 - 0.4, top = 4 + 0.8;
    const double end = 20 + 0.4 + (ticks * 4 * dt - (foot - start) - 2 * slope - top);
    // A skin's offset is longer or shorter by less than a skin at each of the four corners.
    CHECK(std::fabs(slider.slide.position.x() - end) < 4 * skin);
    CHECK(std::fabs(slider.slide.position.y() - 0.9 - skin) < 1e-12);
}

TEST_CASE("round and boxed movers cross random hills at constant speed, on the floor in every tick", "[movers]") {
    Random random(11);
    const std::vector<ShapeDef> shapes = heroes();
    for (int i = 0; i < cases(200); ++i) {
        World world;
        std::vector<Vec2> points{{-20, 0}};
        while (points.back().x() < 60) {
            const double width = random.uniform(1.5, 4);
            points.push_back(points.back() + Vec2(width, random.uniform(-0.95, 0.95) * width));
        }
        points.push_back(points.back() + Vec2(10, 0));
        addStatic(world, {0, 0}, chain({points.rbegin(), points.rend()}));
        SlidingMover slider{addKinematic(world, {-15, 20}, shapes[static_cast<std::size_t>(i) % shapes.size()])};
        slider.land(world, dt);
        const double speed = random.uniform(1, 8);
        for (int tick = 0; tick < 500 && slider.slide.position.x() < 55; ++tick) {
            slider.step(world, speed, dt);
            const double part = slider.slide.displacement.norm() / (speed * dt);
            // Where the ground turns by an angle a within a tick, the way there is a chord: at least cos(a / 2) of it,
            // and a is 90 degrees at most. A skin's offset makes it longer by as much at most.
            if (!slider.slide.isOnFloor || part > 1 + skin / (speed * dt) || part < 0.7)
                FAIL("case " << i << ", tick " << tick << ": " << part << " at " << slider.slide.position.x());
        }
        CHECK(slider.slide.position.x() > -15 + 5 * speed);
    }
}

TEST_CASE("who stands on a slope of up to 45 degrees stays, on a steeper one it slides down", "[movers]") {
    for (double angle : {0.2, 0.6, 0.78}) {
        World world;
        addStatic(world, {0, 0}, box({20, 0.5}), angle);
        SlidingMover slider{addKinematic(world, {0, 2}, box({0.4, 0.9}))};
        slider.land(world);
        const Vec2 start = slider.slide.position;
        for (int i = 0; i < 1000; ++i) slider.step(world, 0, dt);
        CHECK(slider.slide.isOnFloor);
        CHECK(std::fabs(slider.slide.floorAngle - angle) < 1e-12);
        CHECK((slider.slide.position - start).cwiseAbs().maxCoeff() < 1e-12);
    }
    World world;
    addStatic(world, {0, 0}, box({20, 0.5}), 0.85);
    SlidingMover slider{addKinematic(world, {0, 2.5}, box({0.4, 0.9}))};
    for (int i = 0; i < 60; ++i) slider.step(world, slider.slide.velocity.x(), dt);
    CHECK_FALSE(slider.slide.isOnFloor);
    CHECK(slider.slide.position.y() < 0);
    // g sin(a) along a frictionless slope, once it is on it.
    const double along = slider.slide.velocity.norm();
    slider.step(world, slider.slide.velocity.x(), dt);
    CHECK(std::fabs(slider.slide.velocity.norm() - along - 9.81 * sinCos(0.85).sin * dt) < 1e-9);
}

TEST_CASE("steps of 0.25 m are climbed at full speed up to a step height of 0.25 m, and not beyond", "[movers]") {
    for (double height : {0.05, 0.25, 0.26}) {
        World world;
        addStatic(world, {0, -0.5}, box({30, 0.5}));
        for (int k = 0; k < 5; ++k) addStatic(world, {4.0 + k, 0}, {.shape = boxPolygon({0.5, height * (k + 1)})});
        SlidingMover slider{addKinematic(world, {0, 1}, box({0.4, 0.9})), {.stepHeight = 0.25}};
        slider.land(world);
        const double start = slider.slide.position.x();
        int stepped = 0;
        for (int i = 0; i < 100; ++i) {
            slider.step(world, 5, dt);
            for (const SlideHit& hit : slider.slide.hits) stepped += hit.effect == SlideEffect::Stepped;
        }
        if (height < 0.26) {
            CHECK(stepped == 5);
            CHECK(std::fabs(slider.slide.position.y() - 0.9 - 5 * height - skin) < 1e-9);
            // Each step may take it on by two skins, so that it gets onto it.
            CHECK(std::fabs(slider.slide.position.x() - start - 100 * 5 * dt) < 10.1 * skin);
        } else {
            CHECK(stepped == 0);
            CHECK(slider.slide.isOnWall);
            CHECK(std::fabs(slider.slide.position.x() - (3.5 - 0.4 - skin)) < 1e-9);
        }
    }
}

TEST_CASE("without constant speed a slope of 3 in 4 is crossed at 4 m/s level, with it at 3.2", "[movers]") {
    for (bool constant : {true, false}) {
        World world;
        addStatic(world, {0, 0}, chain({{40, 30}, {0, 0}, {-40, -30}}));
        for (double way : {4.0, -4.0}) {
            SlidingMover slider{addKinematic(world, {0, 3}, box({0.4, 0.9})), {.floorConstantSpeed = constant}};
            slider.land(world);
            for (int i = 0; i < 60; ++i) slider.step(world, way, dt);
            CHECK(slider.slide.isOnFloor);
            CHECK(std::fabs(slider.slide.displacement.x() - way * dt * (constant ? 0.8 : 1)) < 1e-12);
            world.remove(slider.body);
        }
    }
}

TEST_CASE("who does not stop on slopes slides down one by the part of its way that lies along it", "[movers]") {
    World world;
    addStatic(world, {0, 0}, chain({{40, 30}, {0, 0}, {-40, -30}}));
    const BodyId body = addKinematic(world, {0, 3}, box({0.4, 0.9}));
    SlidingMover slider{body};
    slider.land(world);
    const SlideSettings slips{.floorStopOnSlope = false};
    const Slide slide = moveAndSlide(world, body, {.velocity = {0, -5}, .dt = dt}, slips, slider.slide);
    CHECK(slide.isOnFloor);
    CHECK((slide.displacement - Vec2(-0.8, -0.6) * (5 * dt * 0.6)).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE(
    "who runs off an edge of 0.3 m at 8 m/s flies, where the floor falls away by a slope of 1 in 2 it stays on it",
    "[movers]") {
    for (bool slope : {false, true}) {
        World world;
        const double end = slope ? 2.6 : 2;
        addStatic(world, {0, 0}, chain({{20, -0.3}, {end, -0.3}, {2, 0}, {-10, 0}}));
        SlidingMover slider{addKinematic(world, {-4, 0.95}, box({0.4, 0.9}))};
        slider.land(world);
        int air = 0;
        for (int i = 0; i < 60; ++i) air += !slider.step(world, 8, dt).isOnFloor;
        CHECK((air > 5) == !slope);
        CHECK((air == 0) == slope);
    }
}

TEST_CASE("who walks over an edge of 0.3 m onto a slope that falls away is not set back", "[movers]") {
    for (const ShapeDef& hero : heroes()) {
        for (const double speed : {1.0, 2.63, 4.0}) {
            for (int phase = 0; phase < 20; ++phase) {
                World world;
                addStatic(world, {0, 0}, chain({{20, -9.3}, {2, -0.3}, {-10, -0.3}}));
                // One way, so that there is no wall below its edge.
                ShapeDef slab = box({3, 0.05});
                slab.oneWay = Vec2(0, 1);
                addStatic(world, {-1, -0.05}, slab);
                SlidingMover slider{addKinematic(world, {0.003 * phase, 1}, hero), {.stepHeight = 0.25}};
                slider.land(world);
                for (int i = 0; i < 240; ++i) {
                    const Vec2 way = slider.step(world, speed, dt).displacement;
                    REQUIRE(way.x() > 0);
                    REQUIRE(way.x() < speed * dt * (1 + 1e-9));
                }
            }
        }
    }
}

}  // namespace plumb::test
