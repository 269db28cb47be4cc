// SPDX-License-Identifier: MIT
#include <plumb/ballistics/range.h>

#include <optional>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "v = 20 exact limit": range 40.774719674 m at 45 degrees, t 2.8832080782 s,
// apex 10.193679918 m.
TEST_CASE("at 20 m/s the greatest range is 40.774719674 m, over an apex of 10.193679918 m", "[ballistics][facts]") {
    const std::optional<GreatestRange> result = greatestRange({.speed = 20});
    REQUIRE(result);
    CHECK(std::fabs(result->range - 40.774719674) < 5e-10);
    CHECK(std::fabs(std::atan2(result->shot.velocity.y(), result->shot.velocity.x()) - pi / 4) < 1e-15);
    CHECK(std::fabs(result->shot.time - 2.8832080782) < 5e-11);
    const std::optional<PathPoint> apex = apexOf({.velocity = result->shot.velocity});
    REQUIRE(apex);
    CHECK(std::fabs(apex->position.y() - 10.193679918) < 5e-10);
    CHECK(std::fabs(apex->time - 2.8832080782 / 2) < 5e-11);
    const std::optional<PathPoint> landing = landingOf({.velocity = result->shot.velocity});
    REQUIRE(landing);
    CHECK((landing->position - Vec2(40.774719674, 0)).norm() < 5e-10);
    CHECK(std::fabs(landing->time - 2.8832080782) < 5e-11);
}

TEST_CASE("100,000 apexes and landings are where a path looked at in small steps has them", "[ballistics]") {
    Random random(127);
    Worst apexOff("apex: height off / path"), landingOff("landing: height off / path");
    int wrong = 0, landings = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        const Launch launch{.velocity = towards(random.uniform(-pi, pi), magnitude(random, 0.1, 100)),
                            .height = random.uniform(-1, 1) * magnitude(random, 0.01, 100),
                            .gravity = randomGravity(random)};
        const auto where = [&] { return describe("velocity", launch.velocity, "height", launch.height); };
        const Point u = seenUpright(launch.velocity, launch.gravity);
        const Real g = launch.gravity.norm();
        const auto heightAt = [&](Real t) { return u.y * t - g * t * t / 2; };
        // The last step of 1/1000 of the longest possible flight at which the shot was above the ground.
        const Real longest = 2 * (std::fabs(u.y) / g + std::sqrt(2 * std::fabs(Real(launch.height)) / g));
        Real highest = 0, last = -1;
        for (int k = 0; k <= 1000; ++k) {
            const Real h = heightAt(longest * k / 1000);
            highest = std::max(highest, h);
            if (h >= -launch.height) last = longest * k / 1000;
        }
        const std::optional<PathPoint> apex = apexOf(launch), landing = landingOf(launch);
        const double path = landing ? pathLength({launch.velocity, landing->time}, launch.gravity) : 1;
        wrong += apex.has_value() != (u.y > 0);
        // A parabola between two steps rises above both by g (step / 2)^2 / 2 at most.
        const Real between = g * (longest / 2000) * (longest / 2000) / 2;
        if (apex) {
            const Real h = seenUpright(apex->position, launch.gravity).y;
            wrong += h < highest * (1 - 1e-12L) || h > highest + between + 1e-12L * highest;
            apexOff.hold(static_cast<double>(std::fabs(h - heightAt(apex->time)) / (h + 1e-12L)), where);
        }
        // One that is above the ground for less than a step is not seen by it.
        if (landing.has_value() != (last >= 0)) wrong += !landing || highest + between < -launch.height;
        if (!landing) continue;
        ++landings;
        if (last >= 0) wrong += landing->time < last * (1 - 1e-12L) || landing->time > last + longest / 1000;
        landingOff.hold(std::fabs(static_cast<double>(heightAt(landing->time) + launch.height)) / path, where);
    }
    apexOff.print();
    landingOff.print();
    CHECK(wrong == 0);
    CHECK(landings > cases(100'000) / 3);
    CHECK(apexOff.value() < 1e-12);
    CHECK(landingOff.value() < 1e-12);
}

TEST_CASE("no angle of 100,000 goes further than the greatest range", "[ballistics][shots]") {
    Random random(131);
    Worst further("greatest range: another angle goes further, relative");
    Worst off("greatest range: its own shot lands elsewhere, relative");
    for (int i = 0; i < cases(100'000) / 100; ++i) {
        const double speed = magnitude(random, 0.1, 100), g = magnitude(random, 0.1, 100);
        const double height = random.uniform(-0.4, 4) * speed * speed / g;
        const std::optional<GreatestRange> best = greatestRange({speed, height, {0, -g}});
        const auto where = [&] { return describe("speed", speed, "gravity", g, "height", height); };
        REQUIRE(best);
        const std::optional<PathPoint> own = landingOf({best->shot.velocity, height, {0, -g}});
        REQUIRE(own);
        off.hold(std::fabs(own->position.x() - best->range) / best->range, where);
        off.hold(std::fabs(own->time / best->shot.time - 1), where);
        for (int k = 0; k < 100; ++k) {
            const std::optional<PathPoint> other =
                landingOf({towards(random.uniform(-1.57, 1.57), speed), height, {0, -g}});
            if (other) further.hold(other->position.x() / best->range - 1, where);
        }
    }
    further.print();
    off.print();
    CHECK(further.value() < 1e-14);
    CHECK(off.value() < 1e-7);  // near the ground's limit a landing is the root of a difference of 1e-16
}

TEST_CASE("shots that never come down, and ranges that are none, are empty", "[ballistics]") {
    CHECK_FALSE(apexOf({.velocity = {1, 0}}));
    CHECK_FALSE(apexOf({.velocity = {1, 1}, .gravity = {0, 0}}));
    CHECK_FALSE(landingOf({.velocity = {1, 1}, .gravity = {0, 0}}));
    CHECK_FALSE(landingOf({.velocity = {1, 1}, .height = -1}));  // rises 5 cm
    CHECK_FALSE(landingOf({.velocity = {1, -1}, .height = -1}));
    CHECK(landingOf({.velocity = {1, -1}})->time == 0);
    CHECK(landingOf({.velocity = {0, 0}})->time == 0);
    CHECK_FALSE(greatestRange({.speed = 1, .gravity = {0, 0}}));
    CHECK_FALSE(greatestRange({.speed = 1, .height = -1}));
    CHECK(greatestRange({.speed = 0, .height = 5})->range == 0);
    CHECK(greatestRange({.speed = 0})->range == 0);
    CHECK_THROWS_WITH(greatestRange({.speed = -1}), containsText("RangeAim.speed: -1 is not within"));
    CHECK_THROWS_WITH(landingOf({.velocity = {1e60, 0}}), containsText("Launch.velocity: 1e+60 is not within"));
}
