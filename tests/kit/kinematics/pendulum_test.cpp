// SPDX-License-Identifier: MIT
#include <plumb/kinematics/pendulum.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "catch.h"

namespace {

using namespace plumb;
using std::numbers::pi;

}  // namespace

// Worked numbers of response: a thread of 1 m, swings of 45, 90 and 150 degrees; a rod of 1 m on its end, I = m L^2 /
// 3; a disc of 1 m on its rim, I = 3 m r^2 / 2.
TEST_CASE("1 m of thread swings in 2.0060666807 s, a rod in 1.6379465859 s, a disc on its rim in 2.4569198789 s",
          "[kinematics][facts]") {
    const double small = pendulumPeriod({});
    CHECK(std::fabs(small - 2.0060666807) < 5e-11);
    CHECK(std::fabs(pendulumPeriod({}, pi / 4) / small - 1.0399733432) < 5e-11);
    CHECK(std::fabs(pendulumPeriod({}, pi / 2) / small - 1.1803405990) < 5e-11);
    CHECK(std::fabs(pendulumPeriod({}, -5 * pi / 6) / small - 1.7622037295) < 5e-11);
    CHECK(std::fabs(pendulumPeriod({.inertia = 1.0 / 3, .distance = 0.5}) - 1.6379465859) < 5e-11);
    CHECK(std::fabs(pendulumPeriod({.inertia = 3, .mass = 2}) - 2.4569198789) < 5e-11);
}

TEST_CASE("a pendulum's period is its elliptic integral, and the series' for small swings", "[kinematics][facts]") {
    // T = 4 sqrt(I / (m g l)) K(sin(A / 2)), by the standard library in long double.
    double worst = 0;
    const double small = pendulumPeriod({});
    for (int i = 0; i < 3142; ++i) {
        const double angle = 0.001 * i;
        const long double half = 0.5L * angle,
                          truth = std::comp_ellint_1(std::sin(half)) * 2 / std::numbers::pi_v<long double>;
        worst = std::max(worst, static_cast<double>(std::fabs(pendulumPeriod({}, angle) / small / truth - 1)));
    }
    std::cout << "kinematics, pendulum: worst " << worst << " of the period\n";
    CHECK(worst < 1e-14);  // some ten roundings, and near pi the last places of a small cosine
    // 1 + A^2 / 16 + 11 A^4 / 3072, whose next terms are 173 A^6 / 737280 and 22931 A^8 / 1321205760.
    for (const double angle : {0.05, 0.1, 0.2, 0.4}) {
        const double square = angle * angle, series = 1 + square / 16 + 11 * square * square / 3072;
        const double rest = 173 * std::pow(angle, 6) / 737280;
        CHECK(pendulumPeriod({}, angle) / small - series > rest - 5e-16);
        CHECK(pendulumPeriod({}, angle) / small - series < rest * (1 + 0.1 * square) + 5e-16);
    }
}

TEST_CASE("pendulums that nothing is, and swings over the top, are refused by name", "[kinematics][errors]") {
    CHECK_THROWS_WITH(pendulumPeriod({.inertia = 0}), "Pendulum.inertia: 0 is not positive");
    CHECK_THROWS_WITH(pendulumPeriod({.mass = -1}), "Pendulum.mass: -1 is not positive");
    CHECK_THROWS_WITH(pendulumPeriod({.distance = std::nan("")}), "Pendulum.distance: nan is not finite");
    CHECK_THROWS_WITH(pendulumPeriod({.gravity = 0}), "Pendulum.gravity: 0 is not positive");
    CHECK_THROWS_WITH(pendulumPeriod({}, 4), "pendulumPeriod: amplitude: 4 is not between -pi and pi");
    CHECK_THROWS_WITH(pendulumPeriod({.inertia = 1e300, .mass = 1e-300}), "pendulumPeriod: period: inf is not finite");
}
