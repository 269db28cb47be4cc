// SPDX-License-Identifier: MIT
#include <plumb/ballistics/beam.h>

#include <optional>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "no gravity, d = (30, 10), w = (-4, 3)", v = 20 m/s.
TEST_CASE("a beam of 20 m/s meets a target from (30 m, 10 m) at (-4, 3) m/s after 1.4105352667 s",
          "[ballistics][facts]") {
    const std::optional<Shot> shot = aimBeam({.target = {30, 10}, .targetVelocity = {-4, 3}, .speed = 20});
    REQUIRE(shot);
    CHECK(std::fabs(shot->time - 1.4105352667) < 5e-11);
    CHECK(std::fabs(shot->velocity.x() - 17.268521751) < 5e-10);
    CHECK(std::fabs(shot->velocity.y() - 10.089507250) < 5e-10);
}

TEST_CASE("a million beams hit, and where there is none the target outruns every point it could be met at",
          "[ballistics][shots]") {
    Random random(139);
    Worst miss("beam: miss / path of the two"), speed("beam: speed off, relative"), early("beam: met before, relative");
    Worst outrun("beam: none, yet in reach, relative");
    int none = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double fast = magnitude(random, 0.1, 1000);
        const BeamAim problem{.target = towards(random.uniform(-pi, pi), magnitude(random, 0.01, 1000)),
                              .targetVelocity = towards(random.uniform(-pi, pi), fast * magnitude(random, 0.01, 3)),
                              .shooterVelocity = towards(random.uniform(-pi, pi), fast * magnitude(random, 0.01, 1)),
                              .speed = fast};
        const std::optional<Shot> shot = aimBeam(problem);
        const Vec2 w = problem.targetVelocity - problem.shooterVelocity;
        const auto where = [&] { return describe("target", problem.target, "w", w, "speed", fast); };
        // How far the target is less how far the beam is, over both, at any time.
        const auto gapAt = [&](Real t) {
            const Point p{problem.target.x() + t * w.x(), problem.target.y() + t * w.y()};
            return (length(p) - fast * t) / (length(p) + fast * t);
        };
        if (shot) {
            const Real t = shot->time;
            const Point off{shot->velocity.x() * t - problem.target.x() - problem.targetVelocity.x() * t,
                            shot->velocity.y() * t - problem.target.y() - problem.targetVelocity.y() * t};
            const double way = (fast + problem.targetVelocity.norm() + problem.shooterVelocity.norm()) * shot->time;
            miss.hold(static_cast<double>(length(off)) / way, where);
            speed.hold(std::fabs((shot->velocity - problem.shooterVelocity).norm() / fast - 1) * fast /
                           (fast + problem.shooterVelocity.norm()),
                       where);
        }
        none += !shot;
        const double end = shot ? shot->time : 1e4 * problem.target.norm() / fast;
        for (int k = 1; k < 60; ++k) {
            const double gap = static_cast<double>(gapAt(shot ? end * k / 60 : end * std::pow(0.7, k)));
            (shot ? early : outrun).hold(-gap, where);
        }
    }
    for (const Worst* worst : {&miss, &speed, &early, &outrun}) worst->print();
    CHECK(miss.value() < 1e-12);
    CHECK(speed.value() < 1e-12);
    CHECK(early.value() < 1e-12);
    CHECK(outrun.value() < 1e-12);
    CHECK(none > cases(1'000'000) / 20);
}

TEST_CASE("beams at what flees as fast as they are, stands still, or is at the muzzle", "[ballistics]") {
    CHECK_FALSE(aimBeam({.target = {1, 0}, .targetVelocity = {5, 0}, .speed = 5}));
    CHECK(aimBeam({.target = {1, 0}, .targetVelocity = {4, 0}, .speed = 5})->time == 1);
    CHECK(aimBeam({.target = {1, 0}, .targetVelocity = {-5, 0}, .speed = 5})->time == 0.1);
    CHECK(aimBeam({.target = {3, 4}, .speed = 5})->velocity == Vec2(3, 4));
    CHECK(aimBeam({.target = {0, 0}, .shooterVelocity = {1, 1}, .speed = 5})->velocity == Vec2(6, 1));
    CHECK_FALSE(aimBeam({.target = {1, 0}, .speed = 0}));
    CHECK(aimBeam({.target = {1, 0}, .targetVelocity = {-1, 0}, .speed = 0})->time == 1);
    CHECK_THROWS_WITH(aimBeam({.target = {1, 0}, .speed = -2}), containsText("BeamAim.speed: -2 is not within"));
}
