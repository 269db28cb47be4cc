// SPDX-License-Identifier: MIT
// The 1985 profile against the tables of public disassemblies, tick by tick; its twin here counts in whole 4096ths of a
// pixel.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <plumb/movers/platform_mover.h>

#include "catch.h"
#include "kit/movers/stage.h"

namespace plumb::test {

namespace {

constexpr double grain = 1.0 / 16 / 4096;  // [m]

/// What a velocity is in whole grains a tick; a check that it is whole is a part of it.
std::int64_t grainsOf(double metres) {
    const double grains = metres / grain, whole = std::round(grains);
    CHECK(std::fabs(grains - whole) < 1e-6);
    return static_cast<std::int64_t>(whole);
}

/// A character on a long floor, whose top is at y = 0.
struct Stage {
    World world;
    PlatformMover mover;
    std::vector<Vec2> way;  ///< where it was after each tick

    explicit Stage(double drop = 0) : world(), mover(place(drop), profile1985()) {
        while (drop == 0 && !mover.slide().isOnFloor) step({});
        way.clear();
    }
    BodyId place(double drop) {
        world.add({.type = BodyType::Static, .position = {0, -1}, .shapes = {box({500, 1})}});
        return world.add({.type = BodyType::Kinematic, .position = {0, 1.1 + drop}, .shapes = {box({0.4, 1})}});
    }
    void step(const PlatformInput& input) {
        mover.step(world, input, tickOf1985);
        world.step(tickOf1985);
        way.push_back(world.body(mover.body()).position());
    }
    std::int64_t levelSpeed() const { return grainsOf(mover.slide().velocity.x() * tickOf1985); }
    std::int64_t verticalSpeed() const { return grainsOf(mover.slide().velocity.y() * tickOf1985); }
};

constexpr PlatformInput walkRight{.move = 1}, runRight{.move = 1, .run = true}, walkLeft{.move = -1};

int ticksTo(Stage& stage, const PlatformInput& input, std::int64_t speed) {
    int ticks = 0;
    while (stage.levelSpeed() < speed && ticks < 1000) {
        stage.step(input);
        ++ticks;
    }
    return ticks;
}

/// A jump in 256ths of a pixel: how high it is after each tick till it is back, and how fast.
struct Twin {
    std::vector<int> height, speed;
};

struct Band {
    int takeOff, rise, fall;
};

/// Public disassemblies: position, then velocity; fall gravity once let go and a pixel up, or not rising; the fall is
/// cut to 4 where it is 4 or more with a fraction of 80h or more.
Twin jumpTwin(const Band& band, int heldTicks) {
    Twin twin;
    int height = 0, speed = band.takeOff * 256;
    bool rising = true;
    for (int tick = 0; tick == 0 || height > 0; ++tick) {
        if (speed <= 0 || (tick >= heldTicks && height >= 256)) rising = false;
        height += speed;
        speed -= rising ? band.rise : band.fall;
        if (-speed >= 4 * 256 && (-speed) % 256 >= 0x80) speed = -4 * 256;
        twin.height.push_back(height);
        twin.speed.push_back(speed);
    }
    return twin;
}

/// Jumps out of a run at the speed it has, and follows the twin till it is back on the floor.
void checkJump(Stage& stage, const PlatformInput& input, const Band& band, int heldTicks) {
    const double ground =
        stage.way.empty() ? stage.world.body(stage.mover.body()).position().y() : stage.way.back().y();
    const Twin twin = jumpTwin(band, heldTicks);
    PlatformInput jump = input;
    for (std::size_t i = 0; i + 1 < twin.height.size(); ++i) {
        jump.jump = static_cast<int>(i) < heldTicks;
        stage.step(jump);
        // Rounding of the body's place, of some 100 m: 60 ticks of 1.5e-14 each.
        const double pixels = (stage.way.back().y() - ground) * 16;
        if (std::fabs(pixels - twin.height[i] / 256.0) > 1e-10) FAIL("tick " << i << ": " << pixels << " px");
        if (stage.verticalSpeed() != 16 * twin.speed[i]) FAIL("tick " << i << ": speed " << stage.verticalSpeed());
    }
    jump.jump = false;
    stage.step(jump);
    CHECK(stage.mover.slide().isOnFloor);
}

int apexOf(const Twin& twin) {
    return (*std::max_element(twin.height.begin(), twin.height.end()) + 255) / 256;
}

}  // namespace

TEST_CASE("walking takes 41 ticks to its 1.5 pixels a tick, running 45 to its 2.5", "[arcade][movers]") {
    Stage walker, runner;
    CHECK(ticksTo(walker, walkRight, 0x18 * 256) == 41);
    CHECK(ticksTo(runner, runRight, 0x28 * 256) == 45);
    for (int i = 0; i < 10; ++i) {
        walker.step(walkRight);
        runner.step(runRight);
        CHECK(walker.levelSpeed() == 0x18 * 256);
        CHECK(runner.levelSpeed() == 0x28 * 256);
    }
    const auto moved = [](const Stage& stage) {
        return (stage.way.back().x() - stage.way[stage.way.size() - 2].x()) * 16;
    };
    CHECK(std::fabs(moved(walker) - 1.5) < 1e-12);
    CHECK(std::fabs(moved(runner) - 2.5) < 1e-12);
}

TEST_CASE("speed grows by 98h a tick walking and E4h running, and the place by its whole sixteenths of a pixel",
          "[arcade][movers]") {
    for (const auto& [input, adder, most] : {std::tuple(walkRight, 0x98, 0x18), {runRight, 0xE4, 0x28}}) {
        Stage stage;
        int speed = 0, sixteenths = 0;
        for (int tick = 0; tick < 60; ++tick) {
            stage.step(input);
            speed = std::min(speed + adder, most * 256);
            sixteenths += speed / 256;
            CHECK(stage.levelSpeed() == speed);
            CHECK(std::fabs(stage.way.back().x() * 256 - sixteenths) < 1e-9);
        }
    }
}

TEST_CASE("who turns loses twice the adder a tick, and stops at once below 0Bh", "[arcade][movers]") {
    Stage stage;
    ticksTo(stage, walkRight, 0x18 * 256);
    int speed = 0x18 * 256;
    while (speed >= 0x0B * 256) {
        stage.step(walkLeft);
        speed -= 2 * 0x98;
        CHECK(stage.levelSpeed() == speed);
    }
    stage.step(walkLeft);
    CHECK(stage.levelSpeed() == -2 * 0x98);
    stage.step(walkLeft);
    CHECK(stage.levelSpeed() == -3 * 0x98);
}

TEST_CASE("who lets go of run still runs for 10 ticks, and then walks", "[arcade][movers]") {
    Stage stage;
    ticksTo(stage, runRight, 0x28 * 256);
    for (int i = 0; i < 10; ++i) {
        stage.step(walkRight);
        CHECK(stage.levelSpeed() == 0x28 * 256);
    }
    stage.step(walkRight);
    CHECK(stage.levelSpeed() == 0x18 * 256);
}

TEST_CASE("without input a runner loses D0h a tick down to 21h, then 98h, to nothing", "[arcade][movers]") {
    Stage stage;
    ticksTo(stage, runRight, 0x28 * 256);
    int speed = 0x28 * 256;
    while (speed > 0) {
        stage.step(still);
        speed = std::max(0, speed - (speed >= 0x21 * 256 ? 0xD0 : 0x98));
        CHECK(stage.levelSpeed() == speed);
    }
}

TEST_CASE("in the air only who is at 19h or faster runs, and without input none loses speed", "[arcade][movers]") {
    Stage slow, fast;
    ticksTo(slow, walkRight, 0x18 * 256);
    ticksTo(fast, runRight, 0x1B * 256);
    const std::int64_t before = fast.levelSpeed();
    for (int i = 0; i < 12; ++i) {  // longer than the grace
        slow.step({.move = 1, .run = true, .jump = true});
        fast.step({.move = 1, .jump = true});
    }
    CHECK(slow.levelSpeed() == 0x18 * 256);  // run is of no use
    CHECK(fast.levelSpeed() == before + 12 * 0xE4);
    const std::int64_t kept = fast.levelSpeed();
    fast.step({.jump = true});
    CHECK(fast.levelSpeed() == kept);
}

TEST_CASE("a standing jump rises 66 pixels and is back after 53 ticks, held for one tick only, 24 and 21",
          "[arcade][movers]") {
    const Band standing{4, 0x20, 0x70};
    const Twin whole = jumpTwin(standing, 1000), tap = jumpTwin(standing, 1);
    CHECK(apexOf(whole) == 66);
    CHECK(whole.height.size() == 53);
    CHECK(apexOf(tap) == 24);
    CHECK(tap.height.size() == 21);
    for (int held : {1, 2, 5, 10, 20, 32, 33, 1000}) {
        Stage stage;
        checkJump(stage, still, standing, held);
    }
}

TEST_CASE("jumps out of a walk and out of a run have their own forces, in 256ths of a pixel", "[arcade][movers]") {
    for (int held : {1, 3, 12, 30, 1000}) {
        Stage below, walker, justBelow, runner;
        ticksTo(below, walkRight, 0x0F * 256);
        checkJump(below, walkRight, {4, 0x20, 0x70}, held);
        ticksTo(walker, walkRight, 0x10 * 256);
        checkJump(walker, walkRight, {4, 0x1E, 0x60}, held);
        ticksTo(justBelow, runRight, 0x18 * 256);
        checkJump(justBelow, runRight, {4, 0x1E, 0x60}, held);
        ticksTo(runner, runRight, 0x19 * 256);
        checkJump(runner, runRight, {5, 0x28, 0x90}, held);
    }
}

TEST_CASE("long falls go at 4.21875, 4.1875 and 4 pixels a tick on average", "[arcade][movers]") {
    // Which gravity one falls with is settled where one jumps: these jump, run off nothing, and fall 60 m.
    const auto meanFall = [](int speed) {
        Stage stage(0);
        if (speed > 0) ticksTo(stage, speed > 0x18 ? runRight : walkRight, speed * 256);
        stage.step({.move = speed > 0 ? 1.0 : 0.0, .jump = true});
        stage.world.body(stage.mover.body()).setPose({0, 100}, 0);
        for (int i = 0; i < 100; ++i) stage.step({});
        const double from = stage.way.back().y();
        for (int i = 0; i < 240; ++i) stage.step({});  // a multiple of what its swings take: 2, 3, 4, 5, 6, 8 ticks
        return (from - stage.way.back().y()) * 16 / 240;
    };
    CHECK(std::fabs(meanFall(0) - 4.21875) < 1e-9);
    CHECK(std::fabs(meanFall(0x12) - 4.1875) < 1e-9);
    CHECK(std::fabs(meanFall(0x28) - 4.0) < 1e-9);
}

TEST_CASE("a jump takes the floor and a fresh press", "[arcade][movers]") {
    Stage stage;
    for (int i = 0; i < 53; ++i) stage.step({.jump = true});
    REQUIRE(stage.mover.slide().isOnFloor);
    for (int i = 0; i < 10; ++i) {
        stage.step({.jump = true});
        CHECK(stage.mover.slide().isOnFloor);
    }
    stage.step({});
    stage.step({.jump = true});
    CHECK(stage.mover.hasJumped());
    stage.step({});
    stage.step({.jump = true});
    CHECK_FALSE(stage.mover.hasJumped());
}

}  // namespace plumb::test
