// SPDX-License-Identifier: MIT
#include <plumb/kinematics/circular.h>

#include <plumb/kinematics/constant_acceleration.h>
#include <plumb/math/random.h>

#include <cmath>
#include <numbers>

#include "catch.h"

using namespace plumb;

// Differences of fourth order over h = 1e-3 s: off by h^4 w^5 / 30 of the size, up to 6 m/s, so 5e-11; and by a
// rounding of angles up to 18 rad, 2e-15, of that size over h, so 2e-11.
TEST_CASE("the velocity and the acceleration on a circle are the slopes of the place and of the velocity",
          "[kinematics]") {
    Random random(5);
    const double h = 1e-3;
    for (int i = 0; i < 1000; ++i) {
        const CircularMotion motion{{random.uniform(-3, 3), random.uniform(-3, 3)},
                                    random.uniform(0, 2),
                                    random.uniform(-3, 3),
                                    random.uniform(-3, 3)};
        const double t = random.uniform(-5, 5);
        const auto slope = [&](Vec2 CircularPoint::*part) -> Vec2 {
            const Vec2 one = circularAt(motion, t + h).*part - circularAt(motion, t - h).*part;
            const Vec2 two = circularAt(motion, t + 2 * h).*part - circularAt(motion, t - 2 * h).*part;
            return (8 * one - two) / (12 * h);
        };
        const CircularPoint point = circularAt(motion, t);
        CHECK((slope(&CircularPoint::position) - point.velocity).norm() < 7e-11);
        CHECK((slope(&CircularPoint::velocity) - point.acceleration).norm() < 7e-11);
        CHECK(std::fabs((point.position - motion.center).norm() - motion.radius) < 1e-14);
    }
}

TEST_CASE("on a circle of 2 m at 3 rad/s the speed is 6 m/s and the acceleration 18 m/s^2 to the center",
          "[kinematics]") {
    const CircularPoint point = circularAt({.center = {1, 1}, .radius = 2, .angularVelocity = 3}, 0);
    CHECK(point.position == Vec2(3, 1));
    CHECK(point.velocity == Vec2(0, 6));
    CHECK(point.acceleration == Vec2(-18, 0));
    const CircularPoint round =
        circularAt({.center = {1, 1}, .radius = 2, .angularVelocity = 3}, 2 * std::numbers::pi / 3);
    CHECK((round.position - point.position).norm() < 4e-15);
}

TEST_CASE("a wheel that speeds up from 2 rad/s by 3 rad/s^2 has turned by 10 rad after 2 s", "[kinematics]") {
    const MotionSolutions turn = solveMotion({.startVelocity = 2, .acceleration = 3, .time = 2});
    CHECK(turn.motions.at(0).displacement == 10);
    CHECK(turn.motions.at(0).endVelocity == 8);
}

TEST_CASE("a circle of negative radius, and one that is turned too far for a number, are refused by name",
          "[kinematics]") {
    CHECK_THROWS_WITH(circularAt({.radius = -1}, 0), "CircularMotion.radius: -1 is negative");
    CHECK_THROWS_WITH(circularAt({.center = {NAN, 0}}, 0), "CircularMotion.center: (nan, 0) is not finite");
    CHECK_THROWS_WITH(circularAt({}, INFINITY), "time: inf is not finite");
    CHECK_THROWS_WITH(circularAt({.angularVelocity = 1e200}, 1e200),
                      "CircularMotion.angularVelocity * time: inf is not finite");
    CHECK_THROWS_WITH(circularAt({.startAngle = 1e308, .angularVelocity = 1e308}, 1),
                      "CircularMotion.startAngle + angularVelocity * time: inf is not finite");
    CHECK_THROWS_WITH(circularAt({.angularVelocity = 1e200}, 0),
                      "CircularMotion.angularVelocity^2 * radius: inf is not finite");
    const CircularPoint tiny = circularAt({.radius = 1e-200, .angularVelocity = -1e200}, 0);
    CHECK(tiny.velocity == Vec2(0, -1));
    CHECK(tiny.acceleration == Vec2(-1e200, 0));
}
