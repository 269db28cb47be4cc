// SPDX-License-Identifier: MIT
#include <compare/formula/oscillator.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("1 kg on 4 N/m with 0.4 N s/m is at -0.2580702634 m after 1 s", "[compare][formula][facts][law]") {
    // Worked numbers of response, spring: ten decimals, and a period of 3.1574194170 s
    const Oscillator damped{.mass = 1, .stiffness = 4, .damping = 0.4, .offset = 1};
    CHECK(std::abs(displacementAt(damped, 1).value + 0.2580702634) < 6e-11);
    // It is at rest again at each half period.
    CHECK(std::abs(displacementAt(damped, 3.1574194170 / 2).speed) < 2e-9);
    CHECK(std::abs(displacementAt(damped, 3.1574194170).speed) < 2e-9);
}

TEST_CASE("an undamped mass is back after 2 pi sqrt(m / k), and half of that later at the other side",
          "[compare][formula][law]") {
    const Oscillator free{.mass = 9, .stiffness = 4, .offset = 0.5};
    const double period = 3 * 3.141592653589793;  // sqrt(9 / 4) = 1.5
    for (int turn = 1; turn <= 100; ++turn) {
        CHECK(std::abs(displacementAt(free, turn * period).value - 0.5) < 1e-13);
        CHECK(std::abs(displacementAt(free, (turn - 0.5) * period).value + 0.5) < 1e-13);
    }
}

TEST_CASE("an oscillator's closed form solves its equation of motion, damped or not", "[compare][formula][law]") {
    // Critical at 2 sqrt(m k) = 8; on either side of it a bare hair away, too.
    for (const double damping : {0.0, 0.5, 4.0, 8 - 1e-7, 8.0, 8 + 1e-7, 10.0, 200.0}) {
        const Oscillator o{.mass = 2, .stiffness = 8, .damping = damping, .offset = -0.3, .speed = 1.5};
        INFO("damping " << damping);
        CHECK(displacementAt(o, 0).value == -0.3);
        CHECK(displacementAt(o, 0).speed == 1.5);
        constexpr double h = 1e-4;
        for (double t = 0.05; t < 3; t += 0.17) {
            const Displacement before = displacementAt(o, t - h), now = displacementAt(o, t),
                               after = displacementAt(o, t + h);
            // Central differences are off by h^2 / 6 times the third derivative: up to 100^3 in the stiffest case,
            // where it decays with e^(-100 t); 5e-5 leaves that and rounding room.
            CHECK(std::abs((after.value - before.value) / (2 * h) - now.speed) < 5e-5);
            const double acceleration = (after.speed - before.speed) / (2 * h);
            CHECK(std::abs(2 * acceleration + damping * now.speed + 8 * now.value) < 2e-2);
        }
    }
}

TEST_CASE("a mass that creeps through a thick damper never runs away", "[compare][formula]") {
    const Oscillator thick{.mass = 1, .stiffness = 1, .damping = 1e4, .offset = 1};
    CHECK(std::abs(displacementAt(thick, 1e4).value - std::exp(-1.0)) < 1e-7);  // slow root: k / c
    CHECK(std::isfinite(displacementAt(thick, 1e9).value));
}

}  // namespace plumb::compare
