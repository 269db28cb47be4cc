// SPDX-License-Identifier: MIT
// In water, against the tables of public disassemblies: most speed 10h, entry 0Ch, strokes of -1.5 pixels a tick with
// forces 0Dh and 0Ah.
#include <algorithm>
#include <cmath>

#include <plumb/movers/platform_mover.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr double pixel = 1.0 / 16;

/// A character of the 1985 profile on a long floor, whose top is at y = 0.
struct Pool {
    World world;
    PlatformMover mover;

    Pool()
        : mover((addStatic(world, {0, -1}, box({500, 1})), addKinematic(world, {0, 1.1}, box({0.4, 1}))),
                profile1985()) {
        while (!mover.slide().isOnFloor) step({});
    }
    void step(const PlatformInput& input) {
        mover.step(world, input, tickOf1985);
        world.step(tickOf1985);
    }
    double height() const { return (mover.slide().position.y() - 1 - 1e-3) / pixel; }  ///< [pixels]
    /// In sixteenths and 256ths of a pixel a tick.
    double across() const { return mover.slide().velocity.x() * tickOf1985 / pixel * 16; }
    double upward() const { return mover.slide().velocity.y() * tickOf1985 / pixel * 256; }
};

}  // namespace

TEST_CASE("in water nobody walks or runs faster than 10h, and who is led into a scene goes at 0Ch",
          "[arcade][movers]") {
    for (const bool run : {false, true}) {
        Pool pool;
        for (int i = 0; i < 90; ++i) pool.step({.move = 1, .run = run, .swim = true});
        CHECK(std::fabs(pool.across() - 0x10) < 1e-9);
        for (int i = 0; i < 90; ++i) pool.step({.move = 1, .run = run});
        CHECK(std::fabs(pool.across() - (run ? 0x28 : 0x18)) < 1e-9);
        pool.step({.move = 1, .run = run, .swim = true});
        CHECK(std::fabs(pool.across() - 0x10) < 1e-9);
    }
    Pool entry;
    for (int i = 0; i < 90; ++i) entry.step({.move = entryMove1985});
    CHECK(std::fabs(entry.across() - 0x0C) < 1e-9);
}

TEST_CASE("a stroke begins at 1.5 pixels a tick, slows by 0Dh while held and by 0Ah once let go or falling",
          "[arcade][movers]") {
    for (const int held : {1, 4, 10, 20, 1000}) {
        Pool pool;
        // Position, then velocity, in 256ths of a pixel; let go counts from a pixel up.
        int height = 0, speed = 0x180;
        bool rising = true;
        for (int tick = 0; tick < 60; ++tick) {
            pool.step({.jump = tick < held, .swim = true});
            if (speed <= 0 || (tick >= held && height >= 256)) rising = false;
            height += speed;
            speed -= rising ? 0x0D : 0x0A;
            INFO("held " << held << ", tick " << tick);
            REQUIRE(height > 0);
            REQUIRE(std::fabs(pool.height() - height / 256.0) < 1e-9);
            REQUIRE(std::fabs(pool.upward() - speed) < 1e-9);
        }
    }
}

TEST_CASE("each fresh press in mid-water is another stroke, and none in the air", "[arcade][movers]") {
    Pool pool;
    pool.step({.jump = true, .swim = true});
    for (int stroke = 0; stroke < 5; ++stroke) {
        for (int i = 0; i < 15; ++i) pool.step({.swim = true});
        const double before = pool.height();
        CHECK_FALSE(pool.mover.hasJumped());
        pool.step({.jump = true, .swim = true});
        CHECK(pool.mover.hasJumped());
        CHECK(std::fabs(pool.height() - before - 1.5) < 1e-9);
        CHECK(std::fabs(pool.upward() - (0x180 - 0x0D)) < 1e-9);
        pool.step({.jump = true, .swim = true});
        CHECK_FALSE(pool.mover.hasJumped());
    }
    CHECK(pool.height() > 60);
    pool.step({});
    pool.step({.jump = true});
    CHECK_FALSE(pool.mover.hasJumped());
    // Who has no strokes jumps as in the air.
    World world;
    addStatic(world, {0, -1}, box({50, 1}));
    PlatformMover walker(addKinematic(world, {0, 1.001}, box({0.4, 1})));
    for (int i = 0; i < 30; ++i) {
        walker.step(world, {.swim = true}, 1.0 / 60);
        world.step(1.0 / 60);
    }
    walker.step(world, {.jump = true, .swim = true}, 1.0 / 60);
    CHECK(walker.hasJumped());
    world.step(1.0 / 60);
    walker.step(world, {.swim = true}, 1.0 / 60);
    world.step(1.0 / 60);
    walker.step(world, {.jump = true, .swim = true}, 1.0 / 60);
    CHECK_FALSE(walker.hasJumped());
}

}  // namespace plumb::test
