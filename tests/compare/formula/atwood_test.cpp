// SPDX-License-Identifier: MIT
#include <compare/formula/atwood.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("3 kg beside 2 kg fall at 1.962 m/s^2 and pull the rope with 23.544 N", "[compare][formula][facts][law]") {
    const AtwoodMachine machine{.massA = 2, .massB = 3};
    CHECK(std::abs(accelerationOf(machine) - 1.962) < 1e-14);  // Worked numbers of response, Atwood
    CHECK(std::abs(tensionOf(machine) - 23.544) < 1e-13);
    // Newton for each: the rope lifts A and holds B back.
    CHECK(std::abs(tensionOf(machine) - 2 * (9.81 + 1.962)) < 1e-13);
}

TEST_CASE("alike weights on a rope stay", "[compare][formula]") {
    CHECK(accelerationOf({.massA = 2, .massB = 2}) == 0);
    CHECK(tensionOf({.massA = 2, .massB = 2, .gravity = 10}) == 20);
}

}  // namespace plumb::compare
