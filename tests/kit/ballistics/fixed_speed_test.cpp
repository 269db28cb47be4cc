// SPDX-License-Identifier: MIT
#include <plumb/ballistics/fixed_speed.h>

#include <vector>

#include <plumb/ballistics/least_speed.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

namespace {

using namespace plumb::test;
using namespace plumb;

double degrees(const Vec2& v) {
    return std::atan2(v.y(), v.x()) * 180 / pi;
}

Aim randomFixedSpeedAim(Random& random) {
    Aim problem;
    problem.speed = magnitude(random, 0.1, 1000);
    problem.gravity = randomGravity(random);
    // From a thousandth of the greatest range to three times it.
    const double range = problem.speed * problem.speed / problem.gravity.norm();
    problem.target = towards(random.uniform(-pi, pi), range * magnitude(random, 1e-3, 3));
    return problem;
}

std::string textOfAim(const Aim& problem) {
    return describe("target", problem.target, "speed", problem.speed, "gravity", problem.gravity);
}

}  // namespace

// Worked numbers of the firing solution, reference cases; the lecture, slides 13 to 16: v = 20 m/s, d = (30, 5) m.
TEST_CASE("at 20 m/s a target at (30 m, 5 m) is hit at 36.176477529 and at 63.285844679 degrees",
          "[ballistics][facts]") {
    const std::vector<Shot> shots = aim({.target = {30, 5}, .speed = 20});
    REQUIRE(shots.size() == 2);
    CHECK(std::fabs(shots[0].time - 1.8582692722) < 5e-11);
    CHECK(std::fabs(shots[0].velocity.x() - 16.144054282) < 5e-10);
    CHECK(std::fabs(shots[0].velocity.y() - 11.805486494) < 5e-10);
    CHECK(std::fabs(degrees(shots[0].velocity) - 36.176477529) < 5e-10);
    CHECK(std::fabs(shots[1].time - 3.3367464652) < 5e-11);
    CHECK(std::fabs(shots[1].velocity.x() - 8.9907939703) < 5e-11);
    CHECK(std::fabs(shots[1].velocity.y() - 17.865207074) < 5e-10);
    CHECK(std::fabs(degrees(shots[1].velocity) - 63.285844679) < 5e-10);
}

// Worked numbers of the firing solution; slide 16 puts gravity to 18: S^2 = B^2 - g^2 D^2 = -203600.
TEST_CASE("at a gravity of 18 m/s^2 no shot of 20 m/s hits (30 m, 5 m)", "[ballistics][facts]") {
    CHECK(aim({.target = {30, 5}, .speed = 20, .gravity = {0, -18}}).empty());
    const double b = 400 - 18 * 5;
    CHECK(b * b - 18 * 18 * (30 * 30 + 5 * 5) == -203600);
}

// Worked numbers of the firing solution: the exact limit is v^2 / g = 40.774719674 m, at 45 degrees, t 2.8832080782 s.
TEST_CASE("at 20 m/s a level target at 40.774719674 m, the limit, is hit by one shot, at 45 degrees",
          "[ballistics][facts]") {
    const double limit = 20 * 20 / 9.81;
    CHECK(std::fabs(limit - 40.774719674) < 5e-10);
    const std::vector<Shot> shots = aim({.target = {limit, 0}, .speed = 20});
    REQUIRE(shots.size() == 1);
    CHECK(std::fabs(degrees(shots[0].velocity) - 45) < 1e-6);
    CHECK(std::fabs(shots[0].time - 2.8832080782) < 5e-8);  // the root of a difference of 1e-16 is all that is left
    CHECK(aim({.target = {limit * (1 + 1e-12), 0}, .speed = 20}).empty());
    CHECK(aim({.target = {limit * (1 - 1e-12), 0}, .speed = 20}).size() == 2);
}

TEST_CASE("a million shots of fixed speed hit, by both arcs", "[ballistics][shots]") {
    Random random(101);
    Worst speed("fixed speed: speed off, relative"), time("fixed speed: miss at the time / path");
    Worst angle("fixed speed: miss by angle / path"), reach("fixed speed: none, yet within reach / distance");
    Worst outside("fixed speed: hit, yet beyond reach / distance");
    int disorder = 0, counts[3] = {0, 0, 0};
    for (int i = 0; i < cases(1'000'000); ++i) {
        const Aim problem = randomFixedSpeedAim(random);
        const std::vector<Shot> shots = aim(problem);
        const auto where = [&] { return textOfAim(problem); };
        ++counts[shots.size()];
        const double beyond = beyondReach(problem.speed, problem.target, problem.gravity);
        if (shots.empty()) reach.hold(-beyond, where);
        if (!shots.empty()) outside.hold(beyond, where);
        for (const Shot& shot : shots) {
            const double path = pathLength(shot, problem.gravity);
            speed.hold(std::fabs(shot.velocity.norm() / problem.speed - 1), where);
            time.hold(missAtTime(shot, problem.target, problem.gravity) / path, where);
            angle.hold(missByAngle(shot, problem.target, problem.gravity) / path, where);
        }
        if (shots.size() == 2) {
            const Vec2 up = -problem.gravity;
            disorder += shots[0].time > shots[1].time || shots[0].velocity.dot(up) > shots[1].velocity.dot(up);
        }
    }
    for (const Worst* worst : {&speed, &time, &angle, &reach, &outside}) worst->print();
    CHECK(speed.value() < 1e-12);
    CHECK(time.value() < 1e-9);
    CHECK(angle.value() < 1e-9);
    // Rounding of some squares and their sum: 1e-15 of the largest.
    CHECK(reach.value() < 1e-13);
    CHECK(outside.value() < 1e-13);
    CHECK(disorder == 0);
    CHECK(counts[0] > cases(1'000'000) / 10);
    CHECK(counts[2] > cases(1'000'000) / 10);
}

TEST_CASE("100,000 targets on the parabola of safety are hit at the speed that just reaches them",
          "[ballistics][shots]") {
    Random random(103);
    Worst speed("limit: speed off, relative"), miss("limit: miss by angle / path");
    int none = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        const double g = magnitude(random, 0.1, 100), v = magnitude(random, 0.1, 1000);
        const double x = random.uniform(-2, 2) * v * v / g;
        const Vec2 target(x, v * v / (2 * g) - g * x * x / (2 * v * v));
        // Rounding puts half of them beyond; a few last places of speed more bring all of them within.
        const Aim problem{.target = target, .speed = v * (1 + 3e-15), .gravity = {0, -g}};
        const std::vector<Shot> shots = aim(problem);
        const auto where = [&] { return textOfAim(problem); };
        none += shots.empty();
        for (const Shot& shot : shots) {
            speed.hold(std::fabs(shot.velocity.norm() / problem.speed - 1), where);
            miss.hold(missByAngle(shot, target, problem.gravity) / pathLength(shot, problem.gravity), where);
        }
    }
    speed.print();
    miss.print();
    CHECK(none == 0);
    CHECK(speed.value() < 1e-12);
    CHECK(miss.value() < 1e-9);
}

TEST_CASE("as gravity goes to 0 the low arc goes to D / v, and at 0 it is that, alone", "[ballistics]") {
    for (const double gravity : {1e-3, 1e-6, 1e-9, 1e-15, 1e-100, 1e-300, 5e-324}) {
        const std::vector<Shot> shots = aim({.target = {3, 4}, .speed = 10, .gravity = {0, -gravity}});
        REQUIRE(!shots.empty());
        // t^2 = 2 D^2 / (B + S) is D^2 / v^2 (1 + g y / v^2 + ...), at most g D / v^2 off; then rounding.
        CHECK(std::fabs(shots[0].time - 0.5) < 0.5 * gravity * 5 / 100 + 2e-16);
        CHECK((shots[0].velocity - Vec2(6, 8)).norm() < gravity * 0.5 + 4e-15);
    }
    const std::vector<Shot> straight = aim({.target = {3, 4}, .speed = 10, .gravity = {0, 0}});
    REQUIRE(straight.size() == 1);
    CHECK(straight[0].time == 0.5);
    CHECK((straight[0].velocity - Vec2(6, 8)).norm() < 2e-15);
}

TEST_CASE("straight up and straight down, at rest and at the muzzle, there is an answer", "[ballistics]") {
    // 10 m up at 20 m/s: 20 t - 9.81 t^2 / 2 = 10.
    const std::vector<Shot> up = aim({.target = {0, 10}, .speed = 20});
    REQUIRE(up.size() == 2);
    CHECK(up[0].velocity == Vec2(0, 20));
    CHECK(up[1].velocity == Vec2(0, 20));
    const double root = std::sqrt(400 - 2 * 9.81 * 10);
    CHECK(std::fabs(up[0].time - (20 - root) / 9.81) < 1e-15);
    CHECK(std::fabs(up[1].time - (20 + root) / 9.81) < 2e-15);

    const std::vector<Shot> down = aim({.target = {0, -10}, .speed = 5});
    REQUIRE(down.size() == 2);
    CHECK(down[0].velocity == Vec2(0, -5));
    CHECK(down[1].velocity == Vec2(0, 5));

    const std::vector<Shot> dropped = aim({.target = {0, -10}, .speed = 0});
    REQUIRE(dropped.size() == 1);
    CHECK(dropped[0].velocity == Vec2(0, 0));
    CHECK(std::fabs(dropped[0].time - std::sqrt(20 / 9.81)) < 1e-15);
    // Dropped, it would miss this by a hundred-millionth of the way, which is not nothing.
    CHECK(aim({.target = {1e-7, -10}, .speed = 0}).empty());

    const std::vector<Shot> here = aim({.target = {0, 0}, .speed = 7});
    REQUIRE(here.size() == 1);
    CHECK(here[0].time == 0);
    CHECK(here[0].velocity == Vec2(0, 7));
    CHECK(aim({.target = {1, 0}, .speed = 0, .gravity = {0, 0}}).empty());
}

// The lecture's pseudo-code, slide 16: t^2 = (-b -+ S) / (2 a) with a = g^2, b = -4 B, c = 4 D^2.
// Worked numbers of the firing solution, lecture defects 1, 2, 5 and 6.
TEST_CASE("where the lecture's pseudo-code gives 178.83 s, 0 or 0 / 0, the shot is right", "[ballistics][facts]") {
    // 1: "/ 2 * a" divides by 2 and multiplies by a: times come out g^2 times as long.
    const std::vector<Shot> low = aim({.target = {30, 5}, .speed = 20});
    const double a = 9.81 * 9.81, b = -4 * (400 - 9.81 * 5), c = 4 * 925;
    const double root = std::sqrt(b * b - 4 * a * c);
    CHECK(std::fabs(std::sqrt((-b - root) / 2 * a) - 178.83) < 5e-3);
    CHECK(std::fabs(low[0].time - 1.8582692722) < 5e-11);
    // 2: it returns (2 d - g t^2) / (2 v^2), where a direction is (2 d - g t^2) / (2 v t).
    const double wrongTime = std::sqrt((-b - root) / 2 * a);
    const Vec2 printed = (2 * Vec2(30, 5) + wrongTime * wrongTime * Vec2(0, 9.81)) / (2 * 20 * 20);
    CHECK((printed - Vec2(0.075, 392.18)).norm() < 5e-3);
    CHECK(std::fabs(degrees(printed) - 89.99) < 5e-3);

    // 5: in float, v = 1000 and x = 1, the minus root cancels to 0 where 0.001 s is due; in double at 1e8 m/s.
    const float fb = -4e6f, fa = 9.81f * 9.81f;
    CHECK((-fb - std::sqrt(fb * fb - 16 * fa)) / (2 * fa) == 0);
    const double db = -4e16;
    CHECK((-db - std::sqrt(db * db - 16 * a)) / (2 * a) == 0);
    CHECK(std::fabs(aim({.target = {1, 0}, .speed = 1000}).front().time - 0.001) < 1e-13);  // g^2 t^3 / 8 v more
    CHECK(aim({.target = {1, 0}, .speed = 1e8}).front().time == 1e-8);

    // 6: without gravity it divides by zero.
    CHECK(std::isnan((1e4 - std::sqrt(1e8)) / (2 * 0.0)));
    CHECK(aim({.target = {1, 0}, .speed = 100, .gravity = {0, 0}}).front().time == 0.01);
}

TEST_CASE("numbers that no aim can be taken with are refused by name", "[ballistics]") {
    CHECK_THROWS_WITH(aim({.target = {0.0 / 0.0, 0}, .speed = 1}), containsText("Aim.target: nan is not finite"));
    CHECK_THROWS_WITH(aim({.target = {1, 0}, .speed = -1}), containsText("Aim.speed: -1 is not within 0 to 1e+50"));
    CHECK_THROWS_WITH(aim({.target = {1, 0}, .speed = 1, .gravity = {1e51, 0}}),
                      containsText("Aim.gravity: 1e+51 is not within -1e+50 to 1e+50"));
}

TEST_CASE("the slowest shot's own speed has a shot, a million times", "[ballistics][shots]") {
    Random random(179);
    int none = 0, two = 0;
    Worst miss("at the least speed: miss at the time / path");
    for (int i = 0; i < cases(1'000'000); ++i) {
        const bool down = random.integer(0, 1) == 0;
        const Vec2 target = towards(random.uniform(-pi, pi), magnitude(random, 0.01, 1e4));
        const Vec2 gravity = down ? Vec2(0, -9.81) : randomGravity(random);
        const Shot slowest = *aimSlowest({target, gravity});
        const std::vector<Shot> shots = aim({target, slowest.velocity.norm(), gravity});
        none += shots.empty();
        two += shots.size() == 2;
        for (const Shot& shot : shots)
            miss.hold(missAtTime(shot, target, gravity) / pathLength(shot, gravity),
                      [&] { return describe("target", target, "gravity", gravity); });
    }
    miss.print();
    CHECK(none == 0);
    CHECK(two == 0);
    CHECK(miss.value() < 1e-9);
}
