// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/methods.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

// Worked numbers of the lecture's table, computed independently: Kepler's orbit of e = 0.5, 1,000 steps a turn, ten
// turns, the largest relative error of energy to two or three digits.
TEST_CASE("ten turns of 1,000 steps cost 0.58, 9.1e-3, 1.07e-4, 1.27e-4 and 4.6e-9 of the energy", "[compare][lab]") {
    const double known[] = {0.58, 9.1e-3, 1.07e-4, 1.27e-4, 4.6e-9};
    const double halfDigit[] = {0.005, 0.05e-3, 0.005e-4, 0.005e-4, 0.05e-9};
    const MotionProblem orbit = keplerOrbit(0.5);
    const std::vector<Method> methods = knownMethods();
    for (std::size_t i = 0; i < std::size(known); ++i) {
        double worst = 0;
        const int steps = walk(methods[i], orbit, 10 * orbit.period, {.steps = 10'000}, [&](double, const Motion& now) {
            worst = std::max(worst, std::fabs(orbit.energy(now) / orbit.energy(orbit.start) - 1));
        });
        CAPTURE(methods[i].name, worst);
        CHECK(steps == 10'000);
        CHECK(std::fabs(worst - known[i]) < 1.2 * halfDigit[i]);
    }
}

TEST_CASE("a method that chooses its steps makes more of them for a smaller tolerance, and comes to the end",
          "[compare][lab]") {
    const MotionProblem spring = oscillator();
    double end = 0;
    const auto see = [&](double time, const Motion&) { end = time; };
    const int few = walk(knownMethods().back(), spring, 10, {.tolerance = 1e-4}, see);
    CHECK(end == 10);
    CHECK(walk(knownMethods().back(), spring, 10, {.tolerance = 1e-9}, see) > 2 * few);
}

}  // namespace plumb::compare
