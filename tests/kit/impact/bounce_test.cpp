// SPDX-License-Identifier: MIT
#include <plumb/impact/bounce.h>

#include <cmath>

#include "catch.h"

using namespace plumb;

// Worked numbers of response, bounce (textbook): h = 1 m, e = 0.8.
TEST_CASE("a ball dropped from 1 m at e = 0.8 rests after 4.0637127689 s and 4.5555555556 m", "[impact][facts][law]") {
    const auto rest = bouncesToRest({.height = 1, .restitution = 0.8});
    REQUIRE(rest);
    CHECK(std::fabs(rest->time - 4.0637127689) < 0.5e-10);
    CHECK(std::fabs(rest->distance - 4.5555555556) < 0.5e-10);
}

TEST_CASE("flight after flight, a ball touches the floor and turns where the series says", "[impact][law]") {
    for (const double e : {0.0, 0.3, 0.8, 0.999, 1.0}) {
        const DroppedBall ball{.height = 2, .restitution = e, .gravity = 5};
        double speed = std::sqrt(2 * 5 * 2.0), time = speed / 5, way = 2;
        for (int n = 1; n <= 200; ++n) {
            INFO("e " << e << ", bounce " << n);
            CHECK(std::fabs(bounceTime(ball, n) - time) < 200 * 1.1e-16 * 400);  // 200 sums of up to 360 s
            speed *= e;
            const double height = speed * speed / 10;
            CHECK(std::fabs(bounceHeight(ball, n) - height) < 400 * 1.1e-16 * 2);
            time += 2 * speed / 5;
            way += 2 * height;
        }
        if (e > 0.9) continue;  // not yet at rest
        CHECK(std::fabs(bouncesToRest(ball)->time - time) < 1e-13);
        CHECK(std::fabs(bouncesToRest(ball)->distance - way) < 1e-13);
    }
    CHECK(bounceHeight({.height = 3}, 0) == 3);
}

TEST_CASE("a ball at e = 1 never rests, and its billionth bounce comes after a billion flights", "[impact]") {
    CHECK_FALSE(bouncesToRest({.restitution = 1}));
    CHECK(bounceTime({.height = 2, .restitution = 1, .gravity = 4}, 1'000'000'000) == 2.0 * 1'000'000'000 - 1);
    CHECK(bounceHeight({.restitution = 1}, 1'000'000'000) == 1);
    CHECK(bouncesToRest({.height = 0})->time == 0);
}

TEST_CASE("balls that nothing drops are refused by name", "[impact][errors]") {
    CHECK_THROWS_WITH(bouncesToRest({.height = -1}), "DroppedBall.height: -1 is negative");
    CHECK_THROWS_WITH(bouncesToRest({.restitution = 1.5}), "DroppedBall.restitution: 1.5 is not within 0 to 1");
    CHECK_THROWS_WITH(bounceTime({.gravity = 0}, 1), "DroppedBall.gravity: 0 is not positive");
    CHECK_THROWS_WITH(bounceTime({}, 0), "bounceTime: n: 0 is less than 1");
    CHECK_THROWS_WITH(bounceHeight({}, -1), "bounceHeight: n: -1 is negative");
}
