// SPDX-License-Identifier: MIT
#include <compare/closed_form/incline.h>

#include <cmath>
#include <numbers>

#include "catch.h"
#include "compare/closed_form/worked.h"

namespace plumb::compare {
namespace {

const Incline incline{.angle = std::numbers::pi / 6, .gravity = 9.81};

}  // namespace

TEST_CASE("a block with a friction of 0.3 on 30 degrees gains 2.3562872367 m/s^2",
          "[compare][closed_form][facts][law]") {
    CHECK(std::abs(slidingAcceleration(incline, 0.3) - 2.3562872367) < digits);  // Worked numbers of response, incline
}

TEST_CASE("a block on 30 degrees sticks from a friction of 0.5773502692 on", "[compare][closed_form][facts][law]") {
    CHECK(slidingAcceleration(incline, 0.5773502693) == 0);  // Worked numbers of response, incline: the threshold
    CHECK(slidingAcceleration(incline, 0.5773502691) > 0);
    CHECK(slidingAcceleration(incline, 0.7) == 0);
}

TEST_CASE("a disc on 30 degrees gains 3.27 m/s^2, a ring 2.4525, a ball 3.5035714286",
          "[compare][closed_form][facts][law]") {
    CHECK(std::abs(rollingAcceleration(incline, 0.5) - 3.27) < digits);  // Worked numbers of response, rolling
    CHECK(std::abs(rollingAcceleration(incline, 1) - 2.4525) < digits);
    CHECK(std::abs(rollingAcceleration(incline, 0.4) - 3.5035714286) < digits);
}

}  // namespace plumb::compare
