// SPDX-License-Identifier: MIT
#include <compare/formula/pendulum.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("a bullet of 10 g at 100.04 m/s lifts a block of 1 kg by 5 cm", "[compare][formula][facts][law]") {
    const BallisticPendulum shot{.bullet = 0.01, .block = 1, .speed = 100.03589856, .length = 1};
    CHECK(std::abs(riseOf(shot) - 0.05) <
          1e-11);  // Worked numbers of response, ballistic pendulum: eight decimals of 100 m/s
    CHECK(std::abs(1 - std::cos(amplitudeOf(shot)) - 0.05) < 1e-11);
}

TEST_CASE("a bullet too light to see swings the block by its speed over sqrt(g l)", "[compare][formula]") {
    const BallisticPendulum shot{.bullet = 1e-6, .block = 1, .speed = 10, .length = 2};
    const double speed = 1e-5 / (1 + 1e-6);
    CHECK(std::abs(amplitudeOf(shot) / (speed / std::sqrt(2 * 9.81)) - 1) < 1e-9);
}

}  // namespace plumb::compare
