// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag_aim.h>

#include <vector>

#include <plumb/ballistics/detail/quadratic_path.h>

#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/quadratic_drag.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/drag_paths.h"

namespace {

using namespace plumb::test;
using namespace plumb;

QuadraticDragAim randomQuadraticDragAim(Random& random) {
    QuadraticDragAim problem;
    problem.speed = magnitude(random, 1, 300);
    const double gravity = magnitude(random, 0.3, 30);
    problem.gravity = random.integer(0, 1) == 0 ? Vec2(0, -gravity) : towards(random.uniform(-pi, pi), gravity);
    // From a tenth of the terminal speed to five times it.
    const double terminal = problem.speed * magnitude(random, 0.2, 10);
    problem.coefficient = gravity / (terminal * terminal);
    const double range = std::min(problem.speed * problem.speed / gravity, 3 / problem.coefficient);
    problem.target = towards(random.uniform(-pi, pi), range * magnitude(random, 1e-3, 2));
    return problem;
}

std::string textOfQuadraticDragAim(const QuadraticDragAim& p) {
    return describe("target", p.target, "speed", p.speed, "coefficient", p.coefficient, "gravity", p.gravity);
}

bool scanQuadraticDrag(const QuadraticDragAim& problem) {
    const double end = 40 * problem.speed / problem.gravity.norm() + 40 / (problem.coefficient * problem.speed);
    return someAngleHits(QuadraticAir{problem.coefficient, problem.gravity}, problem.speed, problem.target, end);
}

}  // namespace

TEST_CASE("a million shots through quadratic drag hit, and where there is none no angle does", "[ballistics][shots]") {
    Random random(193);
    Worst speed("quadratic drag aim: speed off, relative"), miss("quadratic drag aim: miss / path");
    int counts[3] = {}, disorder = 0, scanned[2] = {}, found[2] = {};
    for (int i = 0; i < cases(1'000'000); ++i) {
        const QuadraticDragAim problem = randomQuadraticDragAim(random);
        const auto where = [&] { return textOfQuadraticDragAim(problem); };
        const std::vector<Shot> shots = aimThroughQuadraticDrag(problem);
        ++counts[shots.size()];
        for (const Shot& shot : shots) {
            speed.hold(std::fabs(shot.velocity.norm() / problem.speed - 1), where);
            const FlownShot flown = flyShot(QuadraticAir{problem.coefficient, problem.gravity}, shot, problem.target);
            miss.hold(flown.miss / flown.path, where);
        }
        if (shots.size() == 2)
            disorder +=
                shots[0].time > shots[1].time || (shots[0].velocity - shots[1].velocity).dot(problem.gravity) < 0;
        // Some with a shot as well, to show that the scan sees those.
        const bool some = !shots.empty();
        if (some ? counts[2] % 4000 != 0 : counts[0] % 400 != 0) continue;
        ++scanned[some];
        found[some] += scanQuadraticDrag(problem);
    }
    speed.print();
    miss.print();
    std::cout << "quadratic drag aim: problems with 0 to 2 shots: " << counts[0] << ' ' << counts[1] << ' ' << counts[2]
              << "; a scan over angles finds " << found[0] << " of " << scanned[0] << " without, " << found[1] << " of "
              << scanned[1] << " with\n";
    CHECK(speed.value() < 1e-12);
    CHECK(miss.value() <= 1e-9);  // what is more was integrated again, to 1e-12
    CHECK(disorder == 0);
    CHECK(found[0] == 0);
    CHECK(scanned[0] > cases(1'000'000) / 10'000);
    CHECK(found[1] >= scanned[1] * 9 / 10);
    CHECK(counts[2] > cases(1'000'000) / 10);
}

TEST_CASE("one over the distance at which a path crosses a line is convex in the launch's slope, for 100,000 paths",
          "[ballistics]") {
    Random random(197);
    Worst bend("quadratic drag: second difference of 1 / distance below 0, relative");
    for (int i = 0; i < cases(100'000); ++i) {
        const double line = std::tan(random.uniform(-1.55, 1.55)), strength = magnitude(random, 1e-6, 1e6);
        const double steeper = magnitude(random, 1e-4, 1e4);
        double inverse[3];
        for (int k = 0; k < 3; ++k)
            inverse[k] = 1 / detail::crossingOf(line, steeper * (0.95 + 0.05 * k), strength).value().across;
        bend.hold((2 * inverse[1] - inverse[0] - inverse[2]) / inverse[1],
                  [&] { return describe("line", line, "steeper", steeper, "strength", strength); });
    }
    bend.print();
    CHECK(bend.value() < 1e-11);
}

TEST_CASE("straight up and down through quadratic drag the times are those of the closed forms",
          "[ballistics][facts]") {
    // Worked numbers of the firing solution, "c = 0.005, up 50": back at the muzzle's level after 3.8191317573
    // + 4.3779184523 s; and the top.
    const std::vector<Shot> back = aimThroughQuadraticDrag({.target = {0, -1e-12}, .speed = 50, .coefficient = 0.005});
    REQUIRE(back.size() == 2);
    CHECK(std::fabs(back[1].time - (3.8191317573 + 4.3779184523)) < 1e-10);
    CHECK(back[1].velocity == Vec2(0, 50));
    CHECK(back[0].velocity == Vec2(0, -50));
    const std::vector<Shot> top =
        aimThroughQuadraticDrag({.target = {0, 82.163273486}, .speed = 50, .coefficient = 0.005});
    REQUIRE(top.size() == 2);
    CHECK(top[0].time < 3.8191317573);
    CHECK(top[1].time > 3.8191317573);
    CHECK(std::fabs(top[0].time + top[1].time - 2 * 3.8191317573) < 1e-8);
    CHECK(aimThroughQuadraticDrag({.target = {0, 82.163273488}, .speed = 50, .coefficient = 0.005}).empty());
    const QuadraticAir air{0.005};
    for (const Vec2& target :
         {Vec2(0, 40), Vec2(0, -40), Vec2(0, -4000), Vec2(1e-9, 40), Vec2(1e-9, -40), Vec2(-1e-25, 40)})
        for (const double speed : {30.0, 40.0, 44.294469181, 50.0, 300.0})
            for (const Shot& shot : aimThroughQuadraticDrag({.target = target, .speed = speed, .coefficient = 0.005}))
                CHECK(flyShot(air, shot, target, 1e-12).miss < 1e-9 * flyShot(air, shot, target, 1e-12).path);
}

TEST_CASE("as drag goes to 0 the shots go to those without it, as gravity does, to a straight one", "[ballistics]") {
    const std::vector<Shot> plain = aim({.target = {30, 5}, .speed = 20});
    for (const double coefficient : {1e-4, 1e-7, 1e-10, 1e-13, 1e-50, 1e-300, 0.0}) {
        const std::vector<Shot> shots =
            aimThroughQuadraticDrag({.target = {30, 5}, .speed = 20, .coefficient = coefficient});
        REQUIRE(shots.size() == 2);
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(std::fabs(shots[k].time - plain[k].time) < 200 * coefficient + 1e-12);
            CHECK((shots[k].velocity - plain[k].velocity).norm() < 2000 * coefficient + 1e-11);
        }
    }
    // Without gravity v = v0 e^(-c s): t = (e^(c D) - 1) / (c v0), here 10 (e - 1).
    const double straight = 10 * (std::exp(1.0) - 1);
    for (const double gravity : {1e-6, 1e-9, 1e-12, 1e-30, 1e-100, 1e-200, 5e-324, 0.0}) {
        const std::vector<Shot> shots =
            aimThroughQuadraticDrag({.target = {6, 8}, .speed = 1, .coefficient = 0.1, .gravity = {0, -gravity}});
        REQUIRE(!shots.empty());
        CHECK(std::fabs(shots[0].time - straight) < 1e3 * gravity + 1e-11);
        CHECK((shots[0].velocity - Vec2(0.6, 0.8)).norm() < 1e2 * gravity + 1e-12);
    }
}

TEST_CASE("a stone dropped from rest falls as slowly through drag as one thrown at next to nothing", "[ballistics]") {
    // e^(c s) = cosh(g t / V), V^2 = g / c: 100 m at c = 0.1 take 10.796 s, and 4.515 s without drag.
    CHECK(std::fabs(aimThroughQuadraticDrag({.target = {0, -100}, .coefficient = 0.1}).at(0).time - 10.796) < 5e-4);
    Worst off("quadratic drag, dropped: time off, relative");
    for (const double coefficient : {0.1, 3.0, 1e-6, 1e-15, 1e-25, 1e-60, 1e-320})
        for (const Vec2& gravity : {Vec2(0, -9.81), Vec2(3, -4)})
            for (const double times : {16.0, 1.0, 0x1p-10})
                for (const double speed : {0.0, 5e-324, 1e-200, 1e-150, 1e-20}) {
                    const Real g = gravity.norm(), depth = coefficient * (times * g), grown = std::expm1(depth);
                    // arcosh(1 + x) = ln(1 + x + sqrt(x (x + 2)))
                    const Real time = std::log1p(grown + std::sqrt(grown * (grown + 2))) / std::sqrt(g * coefficient);
                    const std::vector<Shot> shots = aimThroughQuadraticDrag(
                        {.target = times * gravity, .speed = speed, .coefficient = coefficient, .gravity = gravity});
                    REQUIRE(!shots.empty());
                    off.hold(static_cast<double>(std::fabs(shots[0].time / time - 1)),
                             [&] { return describe("c", coefficient, "times", times, "speed", speed, "g", gravity); });
                }
    off.print();
    CHECK(off.value() < 1e-14);
    // Straight below but for the rounding of its place.
    CHECK(aimThroughQuadraticDrag({.target = {0.6, -0.8}, .coefficient = 0.1, .gravity = {5.886, -7.848}}).size() == 1);
    // Who throws nothing hits nothing above or beside.
    CHECK(aimThroughQuadraticDrag({.target = {0, 1}, .coefficient = 0.1}).empty());
    CHECK(aimThroughQuadraticDrag({.target = {1, -9}, .coefficient = 0.1}).empty());
    CHECK(aimThroughQuadraticDrag({.target = {0, -1}, .coefficient = 0.1, .gravity = {0, 0}}).empty());
}

TEST_CASE("where a target comes out of reach, two shots come together, and then there is none", "[ballistics]") {
    // The greatest level range of 50 m/s with c = 0.005 lies where two becomes none; the two are then close.
    const auto shotsAt = [](double x) {
        return aimThroughQuadraticDrag({.target = {x, 0}, .speed = 50, .coefficient = 0.005});
    };
    double low = 50, high = 250;
    for (int i = 0; i < 60; ++i) (shotsAt(0.5 * (low + high)).empty() ? high : low) = 0.5 * (low + high);
    const std::vector<Shot> last = shotsAt(low * (1 - 1e-9));
    REQUIRE(last.size() == 2);
    CHECK((last[0].velocity - last[1].velocity).norm() < 0.01);
    CHECK(shotsAt(low * (1 + 1e-9)).empty());
    // No angle of a thousand comes down further, by integration until it is below the level.
    double furthest = 0;
    for (int k = 1; k < 1000; ++k) {
        Vec2 before(0, 0);
        fly(QuadraticAir{0.005}, towards(k * pi / 2000, 50), 20, 1e-8, [&](const FlightVector& s, double) {
            const Vec2 now(s[0], s[1]);
            if (now.y() < 0) {
                const double part = before.y() / (before.y() - now.y());
                furthest = std::max(furthest, before.x() + part * (now.x() - before.x()));
            }
            before = now;
            return now.y() < 0;
        });
    }
    // The last step is cut straight where the path is bent: it comes down a little nearer, by its sagitta.
    CHECK(furthest < low + 1e-9);
    CHECK(furthest > low * 0.99);
}

TEST_CASE("heavy drag, at five hundred times the terminal speed, still has its shots", "[ballistics]") {
    const double coefficient = 9.81 * 500 * 500 / 1e4;  // c v^2 / g = 250,000 at 100 m/s
    const QuadraticAir air{coefficient};
    for (const Vec2& target :
         {Vec2(0.01, 0.001), Vec2(0.02, 0), Vec2(0.02, -0.05), Vec2(0.02, -0.2), Vec2(0.02, -3), Vec2(0, -3)}) {
        const std::vector<Shot> shots =
            aimThroughQuadraticDrag({.target = target, .speed = 100, .coefficient = coefficient});
        REQUIRE(shots.size() == 2);
        for (const Shot& shot : shots) {
            const FlownShot flown = flyShot(air, shot, target, 1e-11);
            CHECK(flown.miss < 1e-6 * flown.path);
        }
    }
    CHECK(aimThroughQuadraticDrag({.target = {1, 0}, .speed = 100, .coefficient = coefficient}).empty());
    CHECK_THROWS_WITH(aimThroughQuadraticDrag({.target = {1, 0}, .speed = 1, .coefficient = -1}),
                      containsText("QuadraticDragAim.coefficient: -1 is not within"));
}
