// SPDX-License-Identifier: MIT
#include <plumb/forces/gravity.h>

#include <cmath>

#include "catch.h"
#include "kit/forces/runge_kutta.h"

using namespace plumb;

namespace {

/// Two masses: places of A and B, then velocities of A and B.
test::State<8> orbited(const MutualGravity& gravity, double massA, double massB, const test::State<8>& start,
                       double time, int steps) {
    return test::integrated<8>(start, time, steps, [&](const test::State<8>& s) -> test::State<8> {
        const Vec2 onB = gravityForce(gravity, {massA, s.segment<2>(0)}, {massB, s.segment<2>(2)});
        test::State<8> rate;
        rate << s.tail<4>(), -onB / massA, onB / massB;
        return rate;
    });
}

double energyOf(const MutualGravity& gravity, double massA, double massB, const test::State<8>& s) {
    return massA * s.segment<2>(4).squaredNorm() / 2 + massB * s.segment<2>(6).squaredNorm() / 2 +
           potentialEnergy(gravity, {massA, s.segment<2>(0)}, {massB, s.segment<2>(2)});
}

}  // namespace

TEST_CASE("70 kg are 686.7 N, and 10 m up 6867 J more", "[forces][law]") {
    CHECK((gravityForce(UniformGravity{}, 70) - Vec2(0, -686.7)).norm() < 1e-12);
    CHECK(std::fabs(potentialEnergy(UniformGravity{}, 70, Vec2(3, 10)) - 6867) < 1e-11);
}

TEST_CASE("the Earth pulls 1 kg on its ground with 9.82 N, and the Moon is back after 27.3 days", "[forces][law]") {
    // NASA's fact sheets: 5.9722e24 kg, mean radius 6371 km; the Moon 7.346e22 kg, half axis 384,400 km, 27.3217 days.
    const PointMass earth{5.9722e24, {0, 0}}, stone{1, {0, 6.371e6}};
    CHECK(std::fabs(gravityForce(MutualGravity{}, earth, stone).y() + 9.82) < 0.005);
    const double month = orbitPeriod({}, 5.9722e24 + 7.346e22, 3.844e8) / 86400;
    CHECK(std::fabs(month - 27.3217) < 0.003 * 27.3217);  // the sun pulls too
}

TEST_CASE("two masses on a circle are back after one period, whatever the softening", "[forces][law]") {
    for (const double softening : {0.0, 1.5}) {
        const MutualGravity gravity{.constant = 2, .softening = softening};
        const double massA = 5, massB = 1, distance = 3;
        const double speed = circularOrbitSpeed(gravity, massA + massB, distance);
        test::State<8> start;
        start << 0, 0, distance, 0, 0, -speed / 6, 0, speed * 5 / 6;  // no momentum
        const double period = 2 * 3.141592653589793 * distance / speed;
        if (softening == 0) CHECK(std::fabs(period / orbitPeriod(gravity, 6, distance) - 1) < 1e-15);
        const test::State<8> end = orbited(gravity, massA, massB, start, period, 2000);
        CHECK((end - start).norm() < 1e-9);  // (2 pi / 2000)^4 = 1e-10, and its rate over a turn
    }
}

TEST_CASE("an ellipse with e = 0.5 closes after Kepler's period", "[forces][law]") {
    // At its near end, 1 - e from the focus, at sqrt(G M (1 + e) / (a (1 - e))).
    const MutualGravity gravity{.constant = 1};
    const double massA = 3, massB = 1, a = 2, e = 0.5;
    const double speed = std::sqrt(4 / a * (1 + e) / (1 - e));
    test::State<8> start;
    start << 0, 0, a * (1 - e), 0, 0, -speed / 4, 0, speed * 3 / 4;
    const test::State<8> end = orbited(gravity, massA, massB, start, orbitPeriod(gravity, 4, a), 20'000);
    CHECK((end - start).norm() < 1e-10);
    const test::State<8> half = orbited(gravity, massA, massB, start, orbitPeriod(gravity, 4, a) / 2, 10'000);
    CHECK(((half.segment<2>(2) - half.segment<2>(0)) - Vec2(-a * (1 + e), 0)).norm() < 1e-10);
    CHECK(std::fabs(energyOf(gravity, massA, massB, start) + 3 * 1 / (2 * a)) < 1e-15);  // -G mA mB / (2 a)
    CHECK(std::fabs(energyOf(gravity, massA, massB, half) + 3 * 1 / (2 * a)) < 1e-11);
}

TEST_CASE("masses at one place, or a hair apart, pull with no NaN", "[forces]") {
    const MutualGravity gravity{.constant = 1};
    CHECK(gravityForce(gravity, {1, {2, 3}}, {1, {2, 3}}) == Vec2(0, 0));
    CHECK(gravityForce(gravity, {1, {0, 0}}, {1, {1e-120, 0}}) == Vec2(0, 0));
    CHECK(gravityForce(gravity, {1, {0, 0}}, {1, {0, 1e160}}) == Vec2(0, 0));
    CHECK(gravityForce({.constant = 1, .softening = 0.1}, {1, {2, 3}}, {1, {2, 3}}) == Vec2(0, 0));
    CHECK(potentialEnergy({.constant = 1, .softening = 0.5}, PointMass{2, {2, 3}}, PointMass{3, {2, 3}}) == -12);
    CHECK(potentialEnergy(gravity, PointMass{0, {0, 0}}, PointMass{}) == 0);
}

TEST_CASE("masses and laws of gravity that nothing has are refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(gravityForce(UniformGravity{}, -1), "gravityForce: mass: -1 is negative");
    CHECK_THROWS_WITH(gravityForce(MutualGravity{}, {-1, {0, 0}}, {}), "PointMass a.mass: -1 is negative");
    CHECK_THROWS_WITH(gravityForce(MutualGravity{.constant = -1}, {}, {}), "MutualGravity.constant: -1 is negative");
    CHECK_THROWS_WITH(potentialEnergy(MutualGravity{.softening = -1}, PointMass{}, PointMass{}),
                      "MutualGravity.softening: -1 is negative");
    CHECK_THROWS_WITH(orbitPeriod({}, 1, 0), "orbitPeriod: semiMajorAxis: 0 is not positive");
}
