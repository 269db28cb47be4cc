// SPDX-License-Identifier: MIT
#include <plumb/ballistics/apex.h>

#include <optional>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "exact limit": the shot of 20 m/s at 45 degrees rises 10.193679918 m, comes
// down at 40.774719674 m.
TEST_CASE("over an apex of 10.193679918 m to 40.774719674 m it takes 20 m/s at 45 degrees", "[ballistics][facts]") {
    const std::optional<Shot> shot = aimByApex({.target = {40.774719674, 0}, .apex = 10.193679918});
    REQUIRE(shot);
    CHECK((shot->velocity - towards(pi / 4, 20)).norm() < 1e-9);
    CHECK(std::fabs(shot->time - 2.8832080782) < 1e-9);
}

TEST_CASE("a million shots over a given apex hit, and rise just so high", "[ballistics][shots]") {
    Random random(137);
    Worst time("apex: miss at the time / path"), angle("apex: miss by angle / path"), height("apex: off / path");
    int early = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        ApexAim problem{.target = {0, 0}, .apex = magnitude(random, 0.01, 1000), .gravity = randomGravity(random)};
        const Vec2 up = -problem.gravity.normalized();
        const double high = problem.apex * (random.integer(0, 1) == 0 ? random.uniform(-1, 1) : random.uniform(-10, 1));
        problem.target = high * up + random.uniform(-1, 1) * magnitude(random, 0.01, 10'000) * perp(up);
        const std::optional<Shot> shot = aimByApex(problem);
        if (!shot) {
            // The way to (x, y) and back to y is rounded: right at the apex that may be above it.
            CHECK(high > problem.apex * (1 - 1e-9));
            continue;
        }
        const double path = pathLength(*shot, problem.gravity);
        const auto where = [&] { return describe("target", problem.target, "apex", problem.apex); };
        time.hold(missAtTime(*shot, problem.target, problem.gravity) / path, where);
        angle.hold(missByAngle(*shot, problem.target, problem.gravity) / path, where);
        // By energy, v_y^2 / 2 = g H; and on the way down, or at the top, when it hits.
        const double rise = shot->velocity.dot(up), g = problem.gravity.norm();
        height.hold(std::fabs(rise * rise / (2 * g) - problem.apex) / path, where);
        early += rise / g > shot->time * (1 + 1e-12);
    }
    for (const Worst* worst : {&time, &angle, &height}) worst->print();
    CHECK(time.value() < 1e-9);
    CHECK(angle.value() < 1e-9);
    CHECK(height.value() < 1e-12);
    CHECK(early == 0);
}

TEST_CASE("a target above the apex, a level one with no apex, and no gravity have no shot", "[ballistics]") {
    CHECK_FALSE(aimByApex({.target = {1, 5}, .apex = 4}));
    CHECK_FALSE(aimByApex({.target = {1, 0}, .apex = 0}));
    CHECK_FALSE(aimByApex({.target = {1, 0}, .apex = 4, .gravity = {0, 0}}));
    CHECK(aimByApex({.target = {0, 0}, .apex = 0})->velocity == Vec2(0, 0));
    CHECK(aimByApex({.target = {3, -4}, .apex = 0})->velocity.y() == 0);
    CHECK_THROWS_WITH(aimByApex({.target = {3, -4}, .apex = -1}), containsText("ApexAim.apex: -1 is not within"));
}
