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

TEST_CASE("a disc that rolls but for one rounding rolls on, friction or not", "[impact]") {
    const auto rolls = slideToRoll({.speed = 0.7, .angularVelocity = -0.7 / 0.3, .radius = 0.3, .friction = 0});
    REQUIRE(rolls);
    CHECK(rolls->time == 0);
    CHECK(rolls->speed == 0.7);
    Random random(65);
    int slips = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const double speed = random.uniform(-9, 9), radius = random.uniform(0.01, 3);
        slips += !slideToRoll({.speed = speed, .angularVelocity = -speed / radius, .radius = radius, .friction = 0});
    }
    CHECK(slips == 0);
    CHECK_FALSE(slideToRoll({.speed = 0.7, .angularVelocity = -0.7 / 0.3 * (1 + 1e-15), .radius = 0.3, .friction = 0}));
}

// Worked numbers of response, incline and rolling: 30 degrees; it rolls from mu = tan a k / (1 + k) on.
TEST_CASE("down 30 degrees a disc rolls at 3.27, a ring at 2.4525, a ball at 3.5035714286 m/s^2",
          "[impact][facts][law]") {
    const double angle = M_PI / 6;
    const auto down = [&](double k) { return rollDown({.angle = angle, .inertiaRatio = k}).acceleration; };
    CHECK(std::fabs(down(0.5) - 3.27) < 1e-15);
    CHECK(std::fabs(down(1) - 2.4525) < 1e-15);
    CHECK(std::fabs(down(0.4) - 3.5035714286) < 5e-11);
    // A third of tan 30 degrees for a disc, 2/7 for a ball, half for a ring.
    const double tangent = 0.57735026918962576;
    CHECK(std::fabs(frictionToRoll(angle, 0.5) - tangent / 3) < 1e-15);
    CHECK(std::fabs(frictionToRoll(angle, 0.4) - tangent * 2 / 7) < 1e-15);
    CHECK(std::fabs(frictionToRoll(angle, 1) - tangent / 2) < 1e-15);
    for (const double k : {0.4, 0.5, 1.0}) {
        const double least = frictionToRoll(angle, k);
        CHECK(rollDown({.angle = angle, .inertiaRatio = k, .friction = least * (1 + 1e-14)}).rolls);
        CHECK_FALSE(rollDown({.angle = angle, .inertiaRatio = k, .friction = least * (1 - 1e-14)}).rolls);
    }
    // Down 60 degrees a ring rolls from mu = sqrt(3) / 2 on: with 0.3 it slides, at g (sin a - mu cos a).
    const Descent ring = rollDown({.angle = M_PI / 3, .inertiaRatio = 1, .friction = 0.3});
    CHECK_FALSE(ring.rolls);
    CHECK(std::fabs(ring.acceleration - 9.81 * (std::sqrt(0.75) - 0.15)) < 1e-14);
    CHECK(std::fabs(ring.spinUp - 9.81 * 0.15) < 1e-14);
}

TEST_CASE("100,000 descents obey Newton and Euler", "[impact][law]") {
    Random random(66);
    double off = 0, beyond = 0;
    int rolling = 0, faster = 0;
    const int descents = test::cases(100'000);
    for (int i = 0; i < descents; ++i) {
        const Incline slope{.angle = random.uniform(0, M_PI / 2),
                            .inertiaRatio = random.uniform(0.1, 1),
                            .friction = random.uniform(0, 1),
                            .gravity = random.uniform(1, 20)};
        const Descent down = rollDown(slope);
        // Of 1 kg: friction by Newton's law, and by Euler's, I w' = F r.
        const double pull = slope.gravity * std::sin(slope.angle),
                     most = slope.friction * slope.gravity * std::cos(slope.angle);
        const double friction = pull - down.acceleration;
        off = std::max(off, std::fabs(friction - slope.inertiaRatio * down.spinUp));
        beyond = std::max(beyond, friction - most);
        if (!down.rolls) off = std::max(off, std::fabs(friction - most));
        if (down.rolls) off = std::max(off, std::fabs(down.acceleration - down.spinUp));
        rolling += down.rolls;
        faster += down.spinUp > down.acceleration;
    }
    std::cout << "impact: " << rolling << " of " << descents << " descents roll; forces are off by at most " << off
              << " N\n";
    CHECK(off < 10 * 1.1e-16 * 20);  // some ten roundings of 20 N
    CHECK(beyond < 10 * 1.1e-16 * 20);
    CHECK(faster == 0);
    CHECK(rolling > descents / 10);
    CHECK(rolling < descents * 9 / 10);
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
    CHECK_THROWS_WITH(rollDown({.angle = -1}), "Incline.angle: -1 is not within 0 to 1.5707963267948966");
    CHECK_THROWS_WITH(rollDown({.inertiaRatio = 0}), "Incline.inertiaRatio: 0 is not positive");
    CHECK_THROWS_WITH(rollDown({.friction = std::nan("")}), "Incline.friction: nan is not finite");
    CHECK_THROWS_WITH(rollDown({.gravity = 0}), "Incline.gravity: 0 is not positive");
    CHECK_THROWS_WITH(frictionToRoll(2, 0.5), "frictionToRoll: angle: 2 is not within 0 to 1.5707963267948966");
    CHECK_THROWS_WITH(frictionToRoll(1, 0), "frictionToRoll: inertiaRatio: 0 is not positive");
}
