// SPDX-License-Identifier: MIT
// Movers among movers: who of them is told first?
#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/movers/platform_mover.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

struct Crowd {
    World world;
    std::vector<BodyId> bodies;
    std::vector<SlidingMover> sliders;

    Crowd() { addStatic(world, {0, -0.5}, box({60, 0.5})); }
    void add(double x) {
        bodies.push_back(addKinematic(world, {x, 0.901}, box({0.4, 0.9})));
        sliders.push_back({bodies.back()});
    }
    /// In this order, each at its speed.
    void step(const std::vector<double>& speeds) {
        for (std::size_t i = 0; i < sliders.size(); ++i) {
            SlidingMover& s = sliders[i];
            const double rise = s.slide.isOnFloor ? 0 : s.slide.velocity.y() - s.gravity * dt;
            const SlideMotion motion{
                .velocity = {speeds[i], rise}, .dt = dt, .later = std::span(bodies).subspan(i + 1)};
            s.slide = moveAndSlide(world, s.body, motion, s.settings, s.slide);
        }
        world.step(dt);
    }
    double x(std::size_t i) const { return world.body(bodies[i]).position().x(); }
};

}  // namespace

TEST_CASE("a mover of 5 m/s that has turned around does not push the one beside it, told first, nor before it turned",
          "[movers]") {
    Crowd crowd;
    crowd.add(0);
    crowd.add(-2);
    for (int i = 0; i < 60; ++i) crowd.step({0, 5});
    // It stands in the way, and stays.
    CHECK(crowd.x(0) == 0);
    CHECK(std::fabs(crowd.x(1) + 0.8 + skin) < 1e-12);
    CHECK(crowd.sliders[1].slide.isOnWall);
    for (int i = 0; i < 30; ++i) {
        crowd.step({0, -5});
        CHECK(crowd.x(0) == 0);
        CHECK_FALSE(crowd.sliders[0].slide.isOnWall);
    }
}

TEST_CASE(
    "1,200 ticks of six movers that turn as they like leave each a skin apart, and the one that stands in its place",
    "[movers]") {
    Random random(4);
    for (int n = 0; n < cases(50); ++n) {
        Crowd crowd;
        for (int i = 0; i < 6; ++i) crowd.add(1.3 * i);
        std::vector<double> speeds(6, 0.0);
        const std::size_t stands = static_cast<std::size_t>(random.integer(0, 5));
        for (int tick = 0; tick < 1200; ++tick) {
            for (std::size_t i = 0; i < 6; ++i)
                if (random.integer(0, 9) == 0 && i != stands) speeds[i] = random.uniform(-7, 7);
            crowd.step(speeds);
            for (std::size_t i = 0; i < 6; ++i) {
                REQUIRE_FALSE(crowd.sliders[i].slide.crushed);
                if (i > 0) REQUIRE(crowd.x(i) - crowd.x(i - 1) > 0.8 + skin - 1e-9);
            }
            REQUIRE(crowd.x(stands) == 1.3 * static_cast<double>(stands));
        }
    }
}

TEST_CASE("a platform mover passes on who comes later", "[movers]") {
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    PlatformMover first(addKinematic(world, {0, 0.901}, box({0.4, 0.9}))),
        second(addKinematic(world, {-2, 0.901}, box({0.4, 0.9})));
    const std::vector<BodyId> later{second.body()};
    for (int i = 0; i < 90; ++i) {
        first.step(world, {}, dt, later);
        second.step(world, {.move = 1}, dt);
        world.step(dt);
    }
    CHECK(world.body(first.body()).position().x() == 0);
    CHECK(second.slide().isOnWall);
}

}  // namespace plumb::test
