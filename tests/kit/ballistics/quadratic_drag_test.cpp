// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag.h>

#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

// Worked numbers of the firing solution, "c = 0.005, up 50": terminal speed 44.294469181, rise 3.8191317573 s
// to 82.163273487 m, return at 33.155434439 m/s after 4.3779184523 s. Section 5, "terminal speed": after 3
// s 25.748172225 m/s, fallen 41.234527650.
TEST_CASE("50 m/s up through drag of 0.005 / m rises 82.163273487 m and returns at 33.155434439 m/s",
          "[ballistics][facts]") {
    const QuadraticDrag drag{.coefficient = 0.005};
    CHECK(std::fabs(terminalSpeed(drag) - 44.294469181) < 5e-10);
    const VerticalShot shot = shootUp(50, drag);
    CHECK(std::fabs(shot.riseTime - 3.8191317573) < 5e-11);
    CHECK(std::fabs(shot.height - 82.163273487) < 5e-10);
    CHECK(std::fabs(shot.returnSpeed - 33.155434439) < 5e-10);
    CHECK(std::fabs(shot.fallTime - 4.3779184523) < 5e-11);
    const Fall fall = fallFor(3, drag);
    CHECK(std::fabs(fall.speed - 25.748172225) < 5e-10);
    CHECK(std::fabs(fall.distance - 41.234527650) < 5e-10);
}

TEST_CASE("10,000 vertical shots through quadratic drag agree with a Runge-Kutta method of order 4", "[ballistics]") {
    Random random(191);
    Worst top("quadratic drag, up: height off, relative"), stopped("quadratic drag, up: speed left / launch speed");
    Worst down("quadratic drag, down: distance off, relative"), back("quadratic drag, back: speed off, relative");
    struct State {
        double height = 0, speed = 0;
    };
    for (int i = 0; i < 10'000; ++i) {
        const QuadraticDrag drag{magnitude(random, 1e-4, 1), magnitude(random, 0.1, 100)};
        const double speed = magnitude(random, 0.01, 3) * terminalSpeed(drag);
        const auto where = [&] { return describe("c", drag.coefficient, "g", drag.gravity, "speed", speed); };
        const auto flyOn = [&](State s, double time) {
            const auto rate = [&](double v) { return -drag.gravity - drag.coefficient * v * std::fabs(v); };
            constexpr int steps = 500;
            const double h = time / steps;
            for (int k = 0; k < steps; ++k) {
                const double k1 = rate(s.speed), k2 = rate(s.speed + h / 2 * k1), k3 = rate(s.speed + h / 2 * k2);
                const double k4 = rate(s.speed + h * k3);
                s.height += h * s.speed + h * h / 6 * (k1 + k2 + k3);
                s.speed += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            }
            return s;
        };
        const VerticalShot shot = shootUp(speed, drag);
        const State up = flyOn({0, speed}, shot.riseTime);
        top.hold(std::fabs(up.height / shot.height - 1), where);
        stopped.hold(std::fabs(up.speed) / speed, where);
        const State end = flyOn({}, shot.fallTime);
        down.hold(std::fabs(-end.height / shot.height - 1), where);
        back.hold(std::fabs(-end.speed / shot.returnSpeed - 1), where);
        const Fall fall = fallFor(shot.fallTime, drag);
        down.hold(std::fabs(fall.distance / shot.height - 1), where);
        back.hold(std::fabs(fall.speed / shot.returnSpeed - 1), where);
    }
    for (const Worst* worst : {&top, &stopped, &down, &back}) worst->print();
    // The steps are at most atan(3) / 500 of V / g: the fourth power is 4e-11.
    CHECK(top.value() < 1e-9);
    CHECK(stopped.value() < 1e-9);
    CHECK(down.value() < 1e-9);
    CHECK(back.value() < 1e-9);
}

TEST_CASE("where drag is next to nothing a fall is g t^2 / 2, and after long it is at the terminal speed",
          "[ballistics]") {
    const Fall slight = fallFor(2, {.coefficient = 1e-20});
    CHECK(std::fabs(slight.distance - 19.62) < 1e-14);
    CHECK(std::fabs(slight.speed - 19.62) < 1e-14);
    const Fall drop = fallFor(1e-8, {.coefficient = 0.5});
    CHECK(std::fabs(drop.distance / (9.81 * 0.5e-16) - 1) < 1e-14);
    const Fall late = fallFor(1e6, {.coefficient = 0.5});
    CHECK(std::fabs(late.speed / terminalSpeed({.coefficient = 0.5}) - 1) < 1e-15);
    // s = V t - V^2 / g ln 2
    CHECK(std::fabs(late.distance / (late.speed * 1e6 - 2 * std::log(2.0)) - 1) < 1e-15);
    CHECK(shootUp(0, {.coefficient = 0.5}).height == 0);
    CHECK_THROWS_WITH(shootUp(1, {.coefficient = -1}), containsText("QuadraticDrag.coefficient: -1 is not positive"));
    CHECK_THROWS_WITH(shootUp(1, {.coefficient = 1e-60}),
                      containsText("QuadraticDrag.coefficient: 1e-60 is not within"));
    CHECK_THROWS_WITH(shootUp(1, {.gravity = 0}), containsText("QuadraticDrag.gravity: 0 is not positive"));
    CHECK_THROWS_WITH(fallFor(-1, {.coefficient = 1}), containsText("fallFor: time: -1 is not within"));
}

TEST_CASE("without drag a shot up and a fall are those of the textbook", "[ballistics]") {
    // 20 m/s and 10 m/s^2: 2 s up, 20 m high, and as it came back. The least drag there is makes no difference.
    for (const double coefficient : {0.0, 1e-50}) {
        const QuadraticDrag air{.coefficient = coefficient, .gravity = 10};
        const VerticalShot shot = shootUp(20, air);
        CHECK(std::fabs(shot.riseTime - 2) < 1e-15);
        CHECK(std::fabs(shot.fallTime - 2) < 1e-15);
        CHECK(std::fabs(shot.height - 20) < 1e-14);
        CHECK(shot.returnSpeed == 20);
        const Fall fall = fallFor(2, air);
        CHECK(std::fabs(fall.distance - 20) < 1e-14);
        CHECK(std::fabs(fall.speed - 20) < 1e-14);
    }
    CHECK(terminalSpeed({}) == INFINITY);
    CHECK(shootUp(9.81, {}).riseTime == 1);
}
