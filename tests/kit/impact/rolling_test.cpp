// SPDX-License-Identifier: MIT
#include <plumb/impact/rolling.h>

#include <cmath>
#include <iostream>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

// Worked numbers of response, slide to roll (Coriolis): 3 m/s, friction 0.2.
TEST_CASE("a disc thrown at 3 m/s with a friction of 0.2 rolls at 2 m/s after 0.5096839959 s, 1.2742099898 m on",
          "[impact][facts][law]") {
    const auto disc = slideToRoll({.speed = 3, .inertiaRatio = 0.5, .friction = 0.2});
    REQUIRE(disc);
    CHECK(disc->speed == 2);
    CHECK(std::fabs(disc->time - 0.5096839959) < 0.5e-10);
    CHECK(std::fabs(disc->distance - 1.2742099898) < 0.5e-10);
    const auto ball = slideToRoll({.speed = 3, .inertiaRatio = 0.4, .friction = 0.2});
    CHECK(std::fabs(ball->speed - 15.0 / 7) < 1e-15);
    CHECK(std::fabs(ball->time - 0.4368719965) < 0.5e-10);
    CHECK(std::fabs(ball->distance - 1.1233851339) < 0.5e-10);
}

TEST_CASE("where it begins to roll is where 100,000 slides end that are braked by m g mu", "[impact][law]") {
    Random random(64);
    double slip = 0, worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const SlidingDisc disc{.speed = random.uniform(-5, 5),
                               .angularVelocity = random.uniform(-20, 20),
                               .radius = random.uniform(0.1, 2),
                               .inertiaRatio = random.uniform(0.1, 1),
                               .friction = random.uniform(0.05, 1)};
        const auto rolls = slideToRoll(disc);
        // Newton's and Euler's laws for 1 kg, with a force of mu g against the slip, for the time it says.
        const double r = disc.radius, inertia = disc.inertiaRatio * r * r;
        const double push = disc.speed + disc.angularVelocity * r > 0 ? -disc.friction * 9.81 : disc.friction * 9.81;
        const double speed = disc.speed + push * rolls->time;
        const double turning = disc.angularVelocity + push * r / inertia * rolls->time;
        const double way = disc.speed * rolls->time + push * rolls->time * rolls->time / 2;
        slip = std::max(slip, std::fabs(speed + turning * r));
        worst = std::max({worst, std::fabs(speed - rolls->speed), std::fabs(turning - rolls->angularVelocity) * r,
                          std::fabs(way - rolls->distance) / (1 + rolls->time)});
    }
    std::cout << "impact: slides that end in rolling are off by at most " << std::max(slip, worst) << " m/s\n";
    CHECK(slip < 10 * 1.1e-16 * 45 * 10);  // some ten roundings of speeds up to 45 m/s, over k down to 0.1
    CHECK(worst < 10 * 1.1e-16 * 45 * 10);
}

TEST_CASE("what rolls already rolls on, and on ice nothing ever does", "[impact]") {
    const auto rolls = slideToRoll({.speed = 2, .angularVelocity = -4, .radius = 0.5, .friction = 0});
    REQUIRE(rolls);
    CHECK(rolls->time == 0);
    CHECK(rolls->speed == 2);
    CHECK_FALSE(slideToRoll({.speed = 2, .friction = 0}));
}

TEST_CASE("a hoop thrown with enough back spin comes back", "[impact][law]") {
    // v0 - k w0 r < 0: a ring of 0.3 m at 2 m/s comes back from 2 / 0.3 rad/s on.
    const SlidingDisc hoop{.speed = 2, .radius = 0.3, .inertiaRatio = 1};
    SlidingDisc more = hoop, less = hoop;
    more.angularVelocity = 6.67;
    less.angularVelocity = 6.66;
    CHECK(slideToRoll(more)->speed < 0);
    CHECK(slideToRoll(less)->speed > 0);
}

TEST_CASE("slides that nothing makes are refused by name", "[impact][errors]") {
    CHECK_THROWS_WITH(slideToRoll({.radius = 0}), "SlidingDisc.radius: 0 is not positive");
    CHECK_THROWS_WITH(slideToRoll({.inertiaRatio = -1}), "SlidingDisc.inertiaRatio: -1 is not positive");
    CHECK_THROWS_WITH(slideToRoll({.friction = -1}), "SlidingDisc.friction: -1 is negative");
    CHECK_THROWS_WITH(slideToRoll({.gravity = 0}), "SlidingDisc.gravity: 0 is not positive");
}
