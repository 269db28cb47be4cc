// SPDX-License-Identifier: MIT
// Does a jump with a hold phase keep its closed forms?
#include <plumb/movers/platform_mover.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases.h"
#include "catch.h"
#include "kit/movers/stage.h"
#include "numbers.h"

#include <plumb/math/random.h>

namespace plumb::test {

namespace {

PlatformProfile profileOf(const JumpBand& band) {
    PlatformProfile profile = modernProfile({.hangShare = 1});
    profile.vertical.jumps = {band};
    profile.vertical.hangSpeed = profile.vertical.leastRise = 0;
    return profile;
}

/// How far a character has risen at each tick of a jump whose key is held for so many ticks.
std::vector<double> riseOf(const PlatformProfile& profile, int held, double tick, int ticks) {
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    PlatformMover mover(addKinematic(world, {0, 0.95}, box({0.4, 0.9})), profile);
    const auto step = [&](bool jump) {
        mover.step(world, {.jump = jump}, tick);
        world.step(tick);
    };
    while (!mover.slide().isOnFloor) step(false);
    const double ground = world.body(mover.body()).position().y();
    std::vector<double> rise;
    for (int i = 0; i < ticks; ++i) {
        step(i < held);
        rise.push_back(world.body(mover.body()).position().y() - ground);
    }
    return rise;
}

/// Height after a time, for a key that is never released.
double heldHeight(const JumpBand& band, double time) {
    const double hold = std::min(time, band.holdTime), left = time - hold;
    const double speed = band.takeOffSpeed + band.holdAcceleration * hold;
    const double rise = (band.takeOffSpeed + speed) / 2 * hold;
    const double up = std::min(left, speed / band.riseGravity), down = left - up;
    return rise + speed * up - band.riseGravity * up * up / 2 - band.fallGravity * down * down / 2;
}

}  // namespace

TEST_CASE("a jump with a hold phase is on its closed curve at each tick, at 30, 60, 144 and 240 Hz", "[movers]") {
    Random random(271);
    for (int i = 0; i < cases(400); ++i) {
        const JumpBand band{.takeOffSpeed = random.uniform(4, 9),
                            .riseGravity = random.uniform(15, 60),
                            .releaseGravity = random.uniform(15, 90),
                            .fallGravity = random.uniform(15, 60),
                            .holdTime = random.uniform(0, 0.3),
                            .holdAcceleration = random.uniform(-12, 10)};
        for (const double hz : {30.0, 60.0, 144.0, 240.0}) {
            const std::vector<double> rise = riseOf(profileOf(band), 1000, 1 / hz, static_cast<int>(0.35 * hz));
            for (std::size_t k = 0; k < rise.size(); ++k) {
                const double truth = heldHeight(band, static_cast<double>(k + 1) / hz);
                if (truth < 0.01) break;  // soon on the floor again
                REQUIRE(std::fabs(rise[k] - truth) < 1e-12);
            }
        }
    }
}

TEST_CASE("a jump with a hold phase rises by its closed form, whenever jump is let go", "[movers]") {
    const JumpBand band{.takeOffSpeed = 7,
                        .riseGravity = 40,
                        .releaseGravity = 80,
                        .fallGravity = 60,
                        .holdTime = 0.2,
                        .holdAcceleration = -5};
    const double tick = 1.0 / 240;
    double before = 0;
    for (int held = 1; held < 120; ++held) {
        const std::vector<double> rise = riseOf(profileOf(band), held, tick, 120);
        const double top = *std::max_element(rise.begin(), rise.end()), height = jumpHeight(band, held * tick);
        CAPTURE(held);
        // The highest of whole ticks: less by at most half a tick's fall from the apex.
        CHECK(top <= height + 1e-12);
        CHECK(top >= height - 80 * tick * tick / 2);
        CHECK(height >= before);
        before = height;
    }
    // By hand: 0.2 s from 7 to 6 m/s are 1.3 m, and 6 m/s against 40 m/s^2 another 0.45 m.
    CHECK(std::fabs(jumpHeight(band, infinity) - 1.75) < 1e-15);
    CHECK(std::fabs(jumpHeight(band, 0) - 49.0 / 160) < 1e-15);
    CHECK(std::fabs(jumpHeight(band, 0.1) - (0.675 + 6.5 * 6.5 / 160)) < 1e-15);
    // Held for 0.05 s after it: from 6 to 4 m/s.
    CHECK(std::fabs(jumpHeight(band, 0.25) - (1.3 + 0.25 + 0.1)) < 1e-14);
    CHECK(std::fabs(jumpHeight({.takeOffSpeed = 1, .holdTime = 9, .holdAcceleration = -2}, infinity) - 0.25) < 1e-15);
    CHECK(jumpHeight({}, infinity) == 2);
}

// The tables of a game of 2018 (pixels of 1/8 m, y up): 105 px/s kept for 0.2 s while jump is held, then 900 px/s^2.
TEST_CASE("a jump at 105 px/s that is held for 0.2 s rises by 21 px, and by 6.125 px more", "[movers][facts]") {
    const double pixel = 1.0 / 8;
    const JumpBand band{.takeOffSpeed = 105 * pixel,
                        .riseGravity = 900 * pixel,
                        .releaseGravity = 900 * pixel,
                        .fallGravity = 900 * pixel,
                        .holdTime = 0.2};
    CHECK(std::fabs(jumpHeight(band, infinity) / pixel - 27.125) < 1e-12);
    const std::vector<double> rise = riseOf(profileOf(band), 1000, dt, 30);
    CHECK(std::fabs(rise[11] / pixel - 21) < 1e-10);
    CHECK(std::fabs(*std::max_element(rise.begin(), rise.end()) / pixel - 27.125) < 900 * dt * dt / 2);
    const std::vector<double> tapped = riseOf(profileOf(band), 1, dt, 30);
    CHECK(std::fabs(tapped[0] / pixel - 1.75) < 1e-10);
    CHECK(*std::max_element(tapped.begin(), tapped.end()) <= jumpHeight(band, dt) + 1e-12);
}

TEST_CASE("in whole ticks a hold phase of 12 ticks keeps the speed for 12 ticks", "[movers]") {
    for (const TickOrder order : {TickOrder::PositionFirst, TickOrder::VelocityFirst}) {
        PlatformProfile profile = profileOf({.takeOffSpeed = 6, .holdTime = 0.2});
        profile.vertical.order = order;
        const std::vector<double> rise = riseOf(profile, 1000, dt, 14);
        for (std::size_t k = 0; k < 12; ++k) CHECK(std::fabs(rise[k] - 0.1 * static_cast<double>(k + 1)) < 1e-12);
        CHECK(rise[13] < 1.4 - 1e-3);
    }
}

TEST_CASE("a designer's jump of 3 m in 0.5 s with a hold of 0.2 s is 3 m high at 0.5 s", "[movers]") {
    for (const double share : {1.0, 0.5}) {
        const PlatformProfile profile =
            modernProfile({.height = 3, .timeToApex = 0.5, .hangShare = share, .holdTime = 0.2});
        const std::vector<double> rise = riseOf(profile, 1000, dt, 30);
        CHECK(std::fabs(rise[29] - 3) < 1e-12);
        CHECK(rise[28] < rise[29]);
    }
    CHECK(modernProfile().vertical.jumps[0].holdTime == 0);
}

TEST_CASE("a ceiling, a blow and a launch end the hold phase of a jump", "[movers]") {
    const JumpBand band{.takeOffSpeed = 6, .riseGravity = 30, .releaseGravity = 30, .fallGravity = 30, .holdTime = 1};
    World world;
    addStatic(world, {0, -0.5}, box({20, 0.5}));
    addStatic(world, {0, 3.5}, box({20, 0.5}));  // 1.1 m over its head
    PlatformMover mover(addKinematic(world, {0, 0.95}, box({0.4, 0.9})), profileOf(band));
    double top = 0;
    for (int i = 0; i < 90; ++i) {
        mover.step(world, {.jump = i > 10}, dt);
        world.step(dt);
        top = std::max(top, mover.slide().position.y());
    }
    CHECK(top < 2.2);
    CHECK(mover.slide().isOnFloor);
    PlatformMover other(addKinematic(world, {9, 50}, box({0.4, 0.9})), profileOf(band));
    other.launch({0, 3});
    for (int i = 0; i < 6; ++i) other.step(world, {.jump = true}, dt), world.step(dt);
    CHECK(std::fabs(other.slide().velocity.y()) < 1e-12);  // 3 m/s in 0.1 s against 30 m/s^2
}

TEST_CASE("a hold phase that is negative, or as long as the time to the apex, is refused", "[movers][errors]") {
    CHECK_THROWS_WITH(PlatformMover(BodyId{}, profileOf({.holdTime = -1})),
                      "PlatformProfile.vertical.jumps[0].holdTime: -1 is negative");
    CHECK_THROWS_WITH(PlatformMover(BodyId{}, profileOf({.holdAcceleration = infinity})),
                      "PlatformProfile.vertical.jumps[0].holdAcceleration: inf is not finite");
    CHECK_THROWS_WITH(modernProfile({.timeToApex = 0.4, .holdTime = 0.4}),
                      "JumpFeel.holdTime: 0.4 is not less than timeToApex, 0.4");
    CHECK_THROWS_WITH(jumpHeight({}, -1), "jumpHeight: held: -1 is not 0 or more");
}

}  // namespace plumb::test
