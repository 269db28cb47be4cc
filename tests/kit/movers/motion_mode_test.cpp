// SPDX-License-Identifier: MIT
// What else a mover may be told of how it moves: floating, at ceilings, on floors that carry nobody.
#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>
#include <plumb/movers/move_and_collide.h>
#include <plumb/movers/move_and_slide.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

const SlideSettings floating{.motionMode = MotionMode::Floating, .stepHeight = 0.25, .ledgeNudge = 0.1};

}  // namespace

TEST_CASE("floating, a mover slides along walls of every direction at 4 m/s times the cosine, and knows no floor",
          "[movers]") {
    for (int k = 0; k < 24; ++k) {
        for (const double angle : {0.3, 0.8, 1.2}) {  // of the way, from the wall's face
            World world;
            const double turn = k * 0.2617993877991494;
            const Rot rot = Rot::fromAngle(turn);
            addStatic(world, rot * Vec2(0, -0.5), box({30, 0.5}), turn);
            const BodyId body = addKinematic(world, rot * Vec2(-10, 0.6), circle(0.5));
            const SinCos way = sinCos(-angle);
            const Vec2 velocity = rot * Vec2(4 * way.cos, 4 * way.sin);
            Slide slide;
            for (int i = 0; i < 120; ++i) {
                slide = moveAndSlide(world, body, {.velocity = velocity, .dt = dt}, floating, slide);
                world.step(dt);
                CHECK_FALSE(slide.isOnFloor);
                CHECK_FALSE(slide.isOnCeiling);
            }
            INFO("wall at " << turn << ", way at " << angle);
            CHECK(slide.isOnWall);
            const Vec2 seen = rot.inverse() * slide.position;
            // Along the wall it loses nothing: some hundred roundings of 10 m.
            CHECK(std::fabs(seen.x() - (-10 + 4 * way.cos * 2)) < 1e-9);
            CHECK(std::fabs(seen.y() - 0.5 - skin) < 1e-9);
            CHECK((slide.velocity - rot * Vec2(4 * way.cos, 0)).cwiseAbs().maxCoeff() < 1e-9);
            CHECK((slide.wallNormal - rot * Vec2(0, 1)).cwiseAbs().maxCoeff() < 1e-9);
        }
    }
}

TEST_CASE("floating, a mover that comes nearer than 15 degrees to head on stops, farther it slides", "[movers]") {
    for (const double degrees : {0.0, 5.0, 14.9, 15.1, 40.0}) {
        World world;
        addStatic(world, {2, 0}, box({0.5, 30}));
        const BodyId body = addKinematic(world, {0, 0}, circle(0.5));
        const SinCos way = sinCos(degrees * 3.141592653589793 / 180);
        Slide slide;
        for (int i = 0; i < 120; ++i) {
            slide = moveAndSlide(world, body, {.velocity = {4 * way.cos, 4 * way.sin}, .dt = dt}, floating, slide);
            world.step(dt);
        }
        INFO(degrees);
        CHECK(slide.isOnWall);
        CHECK(std::fabs(slide.velocity.y() - (degrees > 15 ? 4 * way.sin : 0)) < 1e-12);
        const double reached = 4 * way.sin * (degrees > 15 ? 2 : (1 - skin) / (4 * way.cos));
        CHECK(std::fabs(slide.position.y() - reached) < 1e-9);
    }
}

TEST_CASE("floating in a hollow corner a mover stays, is on a wall, and a platform does not carry it", "[movers]") {
    World world;
    addStatic(world, {0, 0}, chain({{6, 6}, {0, 0}, {-6, 6}}));
    const BodyId under = addKinematic(world, {20, 0}, box({4, 0.5}), {3, 0});
    const BodyId body = addKinematic(world, {0.5, 3}, circle(0.5)), other = addKinematic(world, {20, 1}, circle(0.5));
    Slide slide, rider;
    for (int i = 0; i < 60; ++i) {
        slide = moveAndSlide(world, body, {.velocity = {0, -8}, .dt = dt}, floating, slide);
        rider = moveAndSlide(world, other, {.velocity = {0, -1}, .dt = dt}, floating, rider);
        world.step(dt);
    }
    CHECK_FALSE(slide.isOnFloor);
    CHECK(slide.isOnWall);
    CHECK(slide.displacement.cwiseAbs().maxCoeff() < 1e-9);
    CHECK(rider.isOnWall);
    CHECK(std::fabs(rider.position.x() - 20) < 1e-9);
    CHECK(world.body(under).position().x() > 22);
}

TEST_CASE("at a ceiling a jump aside goes on at 3 m/s, or stops and falls straight down where it may not slide",
          "[movers]") {
    for (const bool slides : {true, false}) {
        World world;
        addStatic(world, {0, 4}, box({30, 0.5}));
        SlidingMover slider{addKinematic(world, {0, 1}, box({0.4, 0.9})), {.slideOnCeiling = slides}};
        slider.slide.velocity = {3, 8};
        int hit = 0;
        for (int i = 0; i < 40 && hit == 0; ++i) {
            slider.step(world, 3, dt);
            if (slider.slide.isOnCeiling) hit = i;
        }
        REQUIRE(hit > 0);
        CHECK(slider.slide.velocity.x() == (slides ? 3 : 0));
        CHECK(slider.slide.velocity.y() == 0);
        const Vec2 at = slider.slide.position;
        slider.step(world, slider.slide.velocity.x(), dt);
        CHECK(std::fabs(slider.slide.position.x() - at.x() - (slides ? 3 * dt : 0)) < 1e-12);
        CHECK(slider.slide.position.y() < at.y());
    }
}

TEST_CASE("who walks at 4 m/s into a wall of 60 degrees stops, or runs up it at 4 cos 60 m/s where it is not blocked",
          "[movers]") {
    for (const bool blocked : {true, false}) {
        World world;
        // Its foot is at x = 3, its face leans away from who comes.
        addStatic(world, {0, 0}, chain({{13, 17.320508075688775}, {3, 0}, {-10, 0}}));
        SlidingMover slider{addKinematic(world, {0, 1}, circle(0.5)), {.floorBlockOnWall = blocked}};
        slider.land(world);
        double top = 0;
        while (!slider.slide.isOnWall) slider.step(world, 4, dt);
        if (blocked) {
            CHECK(slider.slide.isOnFloor);
            CHECK(slider.slide.velocity.isZero(0));
        } else {
            CHECK_FALSE(slider.slide.isOnFloor);
            // Of 4 m/s the part along the wall.
            CHECK((slider.slide.velocity - Vec2(1, std::sqrt(3.0))).cwiseAbs().maxCoeff() < 1e-9);
        }
        for (int i = 0; i < 60; ++i) top = std::max(top, slider.step(world, 4, dt).position.y() - 0.5 - skin);
        CHECK((top > 0.1) == !blocked);
        CHECK(slider.slide.position.y() > 0.5);
    }
}

TEST_CASE("a floor whose category is not among the platform layers carries nobody, and its speed is no one's",
          "[movers]") {
    for (const bool carries : {true, false}) {
        World world;
        ShapeDef belt = box({20, 0.25});
        belt.filter.category = 4;
        const BodyId platform = addKinematic(world, {0, 0}, belt, {2, 0.5});
        SlidingMover slider{addKinematic(world, {0, 1.2}, box({0.4, 0.9})),
                            {.platformFloorLayers = carries ? ~std::uint64_t{0} : ~std::uint64_t{4}}};
        slider.land(world);
        const double from = slider.slide.position.x();
        for (int i = 0; i < 120; ++i) {
            slider.step(world, 0, dt);
            REQUIRE(slider.slide.isOnFloor);
            // It does not sink into it, though it rises.
            CHECK(world.distance({platform, 0}, {slider.body, 0}).separation > 0.9 * skin);
        }
        CHECK(std::fabs(slider.slide.position.x() - from - (carries ? 4 : 0)) < 1e-9);
        CHECK(slider.slide.platformVelocity == (carries ? Vec2(2, 0.5) : Vec2(0, 0)));
        slider.slide = moveAndSlide(world, slider.body, {.velocity = {0, 6}, .dt = dt}, slider.settings, slider.slide);
        CHECK(std::fabs(slider.slide.velocity.x() - (carries ? 2 : 0)) < 1e-12);
    }
}

TEST_CASE("a body is tested along 2,000 random ways, and goes as far as a cast says", "[movers]") {
    Random random(8);
    World world;
    for (int i = 0; i < 60; ++i)
        addStatic(world, {random.uniform(-20, 20), random.uniform(-20, 20)},
                  box({random.uniform(0.2, 2), random.uniform(0.2, 2)}), random.uniform(-3, 3));
    const BodyId body = addKinematic(world, {0, 0}, circle(0.3));
    int stopped = 0;
    for (int i = 0; i < cases(2000); ++i) {
        Vec2 at(random.uniform(-20, 20), random.uniform(-20, 20));
        if (!world.overlapShape(Circle{0.3 + 2 * skin}, {at, {}}, {}).empty()) {
            world.body(body).setPose({100, 100}, 0);
            if (!world.overlapShape(Circle{0.3 + 2 * skin}, {at, {}}, {}).empty()) continue;
        }
        world.body(body).setPose(at, 0);
        const Vec2 shift(random.uniform(-9, 9), random.uniform(-9, 9));
        const FreeMotion tested = testMove(world, body, shift);
        CHECK(world.body(body).position() == at);
        const FreeMotion told = moveAndCollide(world, body, shift, dt);
        world.step(dt);
        world.body(body).setVelocity({0, 0});
        CHECK((told.displacement - tested.displacement).isZero(0));
        CHECK((world.body(body).position() - at - told.displacement).cwiseAbs().maxCoeff() < 1e-12);
        // By bisection: how far all points of the way are clear of everything by a skin.
        world.body(body).setPose({100, 100}, 0);
        const auto isFree = [&](double part) {
            return world.overlapShape(Circle{0.3 + skin - 1e-9}, {at + shift * part, {}}, {}).empty();
        };
        const double length = shift.norm(), reached = told.displacement.norm() / length;
        for (double part = 0; part < reached; part += 0.05 / length) REQUIRE(isFree(part));
        CHECK(told.hit.has_value() == (reached < 1));
        // A micrometre on, it is nearer than a skin, unless it only grazes.
        if (told.hit && told.hit->normal.dot(shift) < -0.1 * length) CHECK_FALSE(isFree(reached + 1e-6 / length));
        stopped += told.hit.has_value();
    }
    CHECK(stopped > cases(2000) / 4);
    CHECK_THROWS_AS(testMove(world, body, {1, 0}, 0), std::invalid_argument);
    CHECK_THROWS_AS(moveAndCollide(world, body, {1, 0}, 0), std::invalid_argument);
    const BodyId crate = world.add({.shapes = {box({1, 1})}});
    CHECK_THROWS_AS(moveAndCollide(world, crate, {1, 0}, dt), std::invalid_argument);
}

}  // namespace plumb::test
