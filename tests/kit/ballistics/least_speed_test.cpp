// SPDX-License-Identifier: MIT
#include <plumb/ballistics/least_speed.h>

#include <optional>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "min speed to d".
TEST_CASE("18.638924382 m/s at 49.731161104 degrees is the least that hits (30 m, 5 m)", "[ballistics][facts]") {
    const std::optional<Shot> shot = aimSlowest({.target = {30, 5}});
    REQUIRE(shot);
    CHECK(std::fabs(shot->velocity.norm() - 18.638924382) < 5e-10);
    CHECK(std::fabs(std::atan2(shot->velocity.y(), shot->velocity.x()) * 180 / pi - 49.731161104) < 5e-10);
    CHECK(std::fabs(shot->time - 2.4900950635) < 5e-11);
}

TEST_CASE("a million slowest shots hit, and slower ones do not", "[ballistics][shots]") {
    Random random(113);
    Worst time("slowest: miss at the time / path"), height("slowest: miss by angle / path");
    Worst faster("slowest: faster than need be, relative"), slower("slowest: a slower one hits, relative");
    int none = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const SlowestAim problem{towards(random.uniform(-pi, pi), magnitude(random, 0.01, 1e4)), randomGravity(random)};
        const std::optional<Shot> shot = aimSlowest(problem);
        none += !shot;
        if (!shot) continue;
        const double path = pathLength(*shot, problem.gravity);
        const auto where = [&] { return describe("target", problem.target, "gravity", problem.gravity); };
        time.hold(missAtTime(*shot, problem.target, problem.gravity) / path, where);
        height.hold(missByAngle(*shot, problem.target, problem.gravity) / path, where);
        // The parabola of safety of a speed a little less leaves the target out, of a little more takes it in.
        const double speed = shot->velocity.norm();
        for (const double off : {1e-14, 1e-13, 1e-12, 1e-11, 1e-10}) {
            if (beyondReach(speed * (1 + off), problem.target, problem.gravity) > 0) faster.hold(off, where);
            if (beyondReach(speed * (1 - off), problem.target, problem.gravity) < 0) slower.hold(off, where);
        }
    }
    for (const Worst* worst : {&time, &height, &faster, &slower}) worst->print();
    CHECK(none == 0);
    CHECK(time.value() < 1e-9);
    CHECK(height.value() < 1e-9);
    CHECK(faster.value() < 1e-11);
    CHECK(slower.value() < 1e-11);
}

TEST_CASE("straight below nothing need be thrown, and without gravity no speed is the least", "[ballistics]") {
    const std::optional<Shot> dropped = aimSlowest({.target = {0, -5}});
    REQUIRE(dropped);
    CHECK(dropped->velocity == Vec2(0, 0));
    CHECK(std::fabs(dropped->time - std::sqrt(10 / 9.81)) < 1e-15);
    const std::optional<Shot> here = aimSlowest({.target = {0, 0}});
    REQUIRE(here);
    CHECK(here->time == 0);
    CHECK_FALSE(aimSlowest({.target = {3, 0}, .gravity = {0, 0}}));
    CHECK_THROWS_WITH(aimSlowest({.target = {3, 1e60}}), containsText("SlowestAim.target: 1e+60 is not within"));
}
