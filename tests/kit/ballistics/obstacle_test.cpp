// SPDX-License-Identifier: MIT
#include <plumb/ballistics/obstacle.h>

#include <optional>
#include <vector>

#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/least_speed.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

namespace {

using namespace plumb::test;
using namespace plumb;

/// The height of a shot above a wall and its margin, by angle; infinite where the wall is not between muzzle and
/// target.
Real spareAbove(const Shot& shot, const Vec2& wall, const WallAim& problem) {
    const Point u = seenUpright(shot.velocity, problem.gravity), top = seenUpright(wall, problem.gravity);
    const Point target = seenUpright(problem.target, problem.gravity);
    if (top.x * target.x <= 0 || std::fabs(top.x) >= std::fabs(target.x)) return INFINITY;
    const Real g = length({problem.gravity.x(), problem.gravity.y()});
    return top.x * u.y / u.x - g * top.x * top.x / (2 * u.x * u.x) - top.y - problem.margin;
}

Real leastSpare(const Shot& shot, const WallAim& problem) {
    Real least = INFINITY;
    for (const Vec2& wall : problem.walls) least = std::min(least, spareAbove(shot, wall, problem));
    return least;
}

/// One to three walls around the way to the target, most of them high enough to matter.
WallAim randomWalls(Random& random) {
    WallAim problem;
    problem.speed = magnitude(random, 1, 100);
    problem.gravity = randomGravity(random);
    const double range = problem.speed * problem.speed / problem.gravity.norm();
    const Vec2 up = -problem.gravity.normalized(), right(up.y(), -up.x());
    const double across = random.uniform(-1, 1) * range;
    problem.target = across * right + random.uniform(-0.4, 0.4) * range * up;
    problem.margin = random.integer(0, 1) * random.uniform(0, 0.02) * range;
    for (int k = random.integer(1, 3); k > 0; --k)
        problem.walls.push_back(random.uniform(-0.1, 1.1) * across * right + random.uniform(-0.2, 0.4) * range * up);
    return problem;
}

std::string textOfWallAim(const WallAim& problem) {
    return describe("target", problem.target, "wall", problem.walls[0], "speed", problem.speed, "gravity",
                    problem.gravity);
}

}  // namespace

// The lecture, slide 16: the lob over a wall. Worked numbers of the firing solution has both arcs of 20 m/s to (30, 5)
// m: at x = 15 m the low one is 6.733 m high, the high one 16.153 m.
TEST_CASE("a wall of 8 m half way leaves the lob of two shots, one of 6 m both, one of 17 m none",
          "[ballistics][facts]") {
    const auto count = [](double height) {
        return aimOver({.target = {30, 5}, .walls = {{15, height}}, .speed = 20}).size();
    };
    CHECK(count(6) == 2);
    CHECK(count(8) == 1);
    CHECK(count(17) == 0);
    const std::vector<Shot> lob = aimOver({.target = {30, 5}, .walls = {{15, 8}}, .speed = 20});
    CHECK(std::fabs(lob.front().time - 3.3367464652) < 5e-11);
    // A wall behind the target, or behind the muzzle, is in nobody's way; a margin raises one that is.
    CHECK(aimOver({.target = {30, 5}, .walls = {{31, 99}, {-1, 99}}, .speed = 20}).size() == 2);
    CHECK(aimOver({.target = {30, 5}, .walls = {{15, 6}}, .margin = 1, .speed = 20}).size() == 1);
}

TEST_CASE("a million shots over a wall hit and clear it, and no other angle does", "[ballistics][shots]") {
    Random random(149);
    Worst low("over a wall: below the margin / path"), miss("over a wall: miss by angle / path");
    Worst kept("over a wall: cleared, yet left out / path");
    int some = 0, fewer = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const WallAim problem = randomWalls(random);
        const auto where = [&] { return textOfWallAim(problem); };
        const std::vector<Shot> shots = aimOver(problem);
        for (const Shot& shot : shots) {
            const double path = pathLength(shot, problem.gravity);
            low.hold(static_cast<double>(-leastSpare(shot, problem)) / path, where);
            miss.hold(missByAngle(shot, problem.target, problem.gravity) / path, where);
        }
        const std::vector<Shot> all = aim({problem.target, problem.speed, problem.gravity});
        for (const Shot& shot : all) {
            bool given = false;
            for (const Shot& other : shots) given = given || other.velocity == shot.velocity;
            if (!given)
                kept.hold(static_cast<double>(leastSpare(shot, problem)) / pathLength(shot, problem.gravity), where);
        }
        some += !shots.empty();
        fewer += shots.size() < all.size();
    }
    for (const Worst* worst : {&low, &miss, &kept}) worst->print();
    CHECK(low.value() < 1e-9);
    CHECK(miss.value() < 1e-9);
    CHECK(kept.value() < 1e-9);
    CHECK(some > cases(1'000'000) / 10);
    CHECK(fewer > cases(1'000'000) / 10);
}

TEST_CASE("a million slowest shots over a wall hit and clear it, and slower ones do not", "[ballistics][shots]") {
    Random random(151);
    Worst low("slowest over a wall: below the margin / path"), miss("slowest over a wall: miss by angle / path");
    Worst time("slowest over a wall: miss at the time / path");
    Worst slower("slowest over a wall: a shot 1e-6 slower clears / path");
    int raised = 0, none = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const WallAim problem = randomWalls(random);
        const auto where = [&] { return textOfWallAim(problem); };
        const std::optional<Shot> shot = aimSlowestOver(problem);
        none += !shot;
        if (!shot) continue;
        const double path = pathLength(*shot, problem.gravity);
        low.hold(static_cast<double>(-leastSpare(*shot, problem)) / path, where);
        miss.hold(missByAngle(*shot, problem.target, problem.gravity) / path, where);
        time.hold(missAtTime(*shot, problem.target, problem.gravity) / path, where);
        raised += shot->velocity.norm() > aimSlowest({problem.target, problem.gravity})->velocity.norm() * 1.001;
        for (const Shot& other : aim({problem.target, shot->velocity.norm() * (1 - 1e-6), problem.gravity}))
            slower.hold(static_cast<double>(leastSpare(other, problem)) / path, where);
    }
    for (const Worst* worst : {&low, &miss, &time, &slower}) worst->print();
    CHECK(none == 0);
    CHECK(low.value() < 1e-9);
    CHECK(miss.value() < 1e-9);
    CHECK(time.value() < 1e-9);
    CHECK(slower.value() == 0);
    CHECK(raised > cases(1'000'000) / 10);
}

TEST_CASE("the slowest shot's own speed has a shot over the wall, a million times", "[ballistics][shots]") {
    CHECK(aimOver({.target = {30, 5}, .walls = {{15, 12}}, .speed = 0}).empty());
    const std::optional<Shot> example = aimSlowestOver({.target = {30, 5}, .walls = {{15, 12}}});
    CHECK(std::fabs(example->velocity.norm() - 18.8371) < 5e-5);
    CHECK(aimOver({.target = {30, 5}, .walls = {{15, 12}}, .speed = example->velocity.norm()}).size() == 1);
    Random random(173);
    Worst low("at the slowest speed over a wall: below the margin / path"), miss("at the slowest speed: miss / path");
    Worst speed("at the slowest speed over a wall: speed off, relative");
    int none = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        WallAim problem = randomWalls(random);
        const std::optional<Shot> slowest = aimSlowestOver(problem);
        if (!slowest) continue;
        problem.speed = slowest->velocity.norm();
        const auto where = [&] { return textOfWallAim(problem); };
        const std::vector<Shot> shots = aimOver(problem);
        none += shots.empty();
        for (const Shot& shot : shots) {
            const double path = pathLength(shot, problem.gravity);
            low.hold(static_cast<double>(-leastSpare(shot, problem)) / path, where);
            miss.hold(missAtTime(shot, problem.target, problem.gravity) / path, where);
            speed.hold(std::fabs(shot.velocity.norm() / problem.speed - 1), where);
        }
    }
    for (const Worst* worst : {&low, &miss, &speed}) worst->print();
    CHECK(none == 0);
    CHECK(low.value() < 1e-9);
    CHECK(miss.value() < 1e-9);
    CHECK(speed.value() < 1e-12);
}

TEST_CASE("without gravity no lob goes over a wall, and bad walls are refused by name", "[ballistics]") {
    CHECK_FALSE(aimSlowestOver({.target = {30, 5}, .walls = {{15, 8}}, .gravity = {0, 0}}));
    CHECK(aimOver({.target = {30, 6}, .walls = {{15, 2}}, .speed = 20, .gravity = {0, 0}}).size() == 1);
    CHECK(aimOver({.target = {30, 6}, .walls = {{15, 4}}, .speed = 20, .gravity = {0, 0}}).empty());
    CHECK_THROWS_WITH(aimOver({.target = {30, 6}, .walls = {{15, 1e70}}, .speed = 20}), containsText("WallAim.walls"));
    CHECK_THROWS_WITH(aimSlowestOver({.target = {30, 6}, .margin = -1}), containsText("WallAim.margin: -1"));
}
