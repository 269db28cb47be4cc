// SPDX-License-Identifier: MIT
#include <plumb/ballistics/fixed_time.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "t = 2 to d".
TEST_CASE("a shot of 2 s to (30 m, 5 m) leaves with (15, 12.31) m/s", "[ballistics][facts]") {
    const Shot shot = aimInTime({.target = {30, 5}, .time = 2});
    CHECK(shot.time == 2);
    CHECK((shot.velocity - Vec2(15, 12.31)).norm() < 1e-14);
}

TEST_CASE("a million shots of fixed time are at their target then", "[ballistics][shots]") {
    Random random(109);
    Worst time("fixed time: miss at the time / path"), height("fixed time: miss by angle / path");
    for (int i = 0; i < cases(1'000'000); ++i) {
        const TimeAim problem{.target = towards(random.uniform(-pi, pi), magnitude(random, 0.01, 1e4)),
                              .time = magnitude(random, 0.01, 100),
                              .gravity = randomGravity(random)};
        const Shot shot = aimInTime(problem);
        const auto where = [&] { return describe("target", problem.target, "time", problem.time); };
        const double path = pathLength(shot, problem.gravity);
        time.hold(missAtTime(shot, problem.target, problem.gravity) / path, where);
        height.hold(missByAngle(shot, problem.target, problem.gravity) / path, where);
    }
    time.print();
    height.print();
    CHECK(time.value() < 1e-9);
    CHECK(height.value() < 1e-9);
}

TEST_CASE("no time is refused by name", "[ballistics]") {
    CHECK_THROWS_WITH(aimInTime({.target = {1, 0}, .time = 0}), containsText("TimeAim.time: 0 is not positive"));
    CHECK_THROWS_WITH(aimInTime({.target = {1, 0}, .time = 1e-60}), containsText("TimeAim.time: 1e-60 is not within"));
}
