// SPDX-License-Identifier: MIT
#include <plumb/forces/magnet.h>

#include <cmath>
#include <iostream>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;

// Jackson, "Classical Electrodynamics", 5.6 and 5.7: a dipole's field is 2 K m / r^3 on its axis, K m / r^3 beside it.
TEST_CASE("two magnets in line pull with 6 K m^2 / r^4, side by side they push with half of it", "[forces][law]") {
    const Magnetism law{.constant = 1};
    const MagnetPull inLine = magnetPull(law, {{0, 0}, {3, 0}}, {{2, 0}, {3, 0}});
    CHECK((inLine.force - Vec2(-6.0 * 9 / 16, 0)).norm() < 1e-14);
    CHECK(inLine.torque == 0);
    const MagnetPull beside = magnetPull(law, {{0, 0}, {0, 3}}, {{2, 0}, {0, 3}});
    CHECK((beside.force - Vec2(3.0 * 9 / 16, 0)).norm() < 1e-14);
    CHECK(std::fabs(potentialEnergy(law, {{0, 0}, {3, 0}}, {{2, 0}, {3, 0}}) + 2.0 * 9 / 8) < 1e-15);
    CHECK(std::fabs(potentialEnergy(law, {{0, 0}, {0, 3}}, {{2, 0}, {0, 3}}) - 9.0 / 8) < 1e-15);
}

TEST_CASE("a needle beside a magnet turns to its field with K m^2 / r^3", "[forces][law]") {
    // Beside A, its field points against its moment: the needle, at right angles, turns that way.
    const MagnetPull pull = magnetPull({.constant = 1}, {{0, 0}, {0, 3}}, {{2, 0}, {3, 0}});
    CHECK(std::fabs(pull.torque + 9.0 / 8) < 1e-15);
}

TEST_CASE("two magnets keep their angular momentum, 100,000 times", "[forces][law]") {
    Random random(41);
    double worst = 0;
    for (int i = 0; i < test::cases(100'000); ++i) {
        const auto someVec2 = [&random] { return Vec2{random.uniform(-3, 3), random.uniform(-3, 3)}; };
        const Magnetism law{.constant = 1, .softening = random.integer(0, 1) == 0 ? 0 : random.uniform(0, 1)};
        const Dipole a{someVec2(), someVec2()}, b{someVec2(), someVec2()};
        const MagnetPull onB = magnetPull(law, a, b), onA = magnetPull(law, b, a);
        const Vec2 d = b.position - a.position;
        const double size = a.moment.norm() * b.moment.norm() / std::pow(std::hypot(d.norm(), law.softening), 3);
        worst = std::max(worst, (onA.force + onB.force).norm() * d.norm() / size);
        worst = std::max(worst, std::fabs(onA.torque + onB.torque + cross(d, onB.force)) / size);
    }
    std::cout << "forces: two magnets' forces and torques add up to 0 but for " << worst << "\n";
    CHECK(worst < 15 * 20 * 1.1e-16);  // some twenty roundings of terms of up to 15 times the size
}

TEST_CASE("magnets at one place do nothing, and no NaN", "[forces]") {
    const MagnetPull pull = magnetPull({}, {{1, 2}, {3, 0}}, {{1, 2}, {0, 3}});
    CHECK(pull.force == Vec2(0, 0));
    CHECK(pull.torque == 0);
    CHECK(magnetPull({}, {{0, 0}, {3, 0}}, {{1e-90, 0}, {0, 3}}).force == Vec2(0, 0));
    CHECK(magnetPull({}, {{0, 0}, {3, 0}}, {{0, 1e100}, {0, 3}}).force == Vec2(0, 0));
    CHECK(potentialEnergy({}, Dipole{}, Dipole{}) == 0);
}

TEST_CASE("magnetism of less than nothing is refused by name", "[forces][errors]") {
    CHECK_THROWS_WITH(magnetPull({.constant = -1}, {}, {}), "Magnetism.constant: -1 is negative");
    CHECK_THROWS_WITH(potentialEnergy(Magnetism{.softening = -1}, Dipole{}, Dipole{}),
                      "Magnetism.softening: -1 is negative");
}
