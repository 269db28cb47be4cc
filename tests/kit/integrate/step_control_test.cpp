// SPDX-License-Identifier: MIT
#include <plumb/integrate/step_control.h>

#include <plumb/math/random.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("the fifth root is within 2 of the last place, from 5e-324 to 1.8e308", "[integrate]") {
    Random random(61);
    double worst = 0;
    for (int i = 0; i < cases(1'000'000); ++i) {
        const double x = std::ldexp(random.uniform(0.5, 1), random.integer(-1073, 1024));
        const long double truth = std::pow(static_cast<long double>(x), 0.2L);
        const double size = static_cast<double>(truth), ulp = std::nextafter(size, 1e308) - size;
        worst = std::max(worst, static_cast<double>(std::fabs(fifthRoot(x) - truth)) / ulp);
    }
    std::cout << "integrate, fifth root: worst " << worst << " ulp\n";
    CHECK(worst <= 2);
    CHECK(fifthRoot(0) == 0);
    CHECK(fifthRoot(32) == 2);
    CHECK(std::isinf(fifthRoot(INFINITY)));
}

TEST_CASE("a step that was 32 times too wrong is tried again at 0.45 of its length", "[integrate]") {
    CHECK(stepFactor(32) == 0.45);
    CHECK(stepFactor(1) == 0.9);
    CHECK(stepFactor(1e10) == 0.2);
    CHECK(stepFactor(INFINITY) == 0.2);
    CHECK(stepFactor(1e-10) == 5);
    CHECK(stepFactor(0) == 5);
}

TEST_CASE("the worst ratio is that of the component furthest beyond its tolerance", "[integrate]") {
    const AdaptiveSettings settings{.absoluteTolerance = 0.1, .relativeTolerance = 0.01};
    const std::array<double, 3> before = {0, 10, -90}, after = {0, 5, 20};
    CHECK(worstRatio(std::array<double, 3>{0.05, 0.1, 0.1}, before, after, settings) == 0.5);
    CHECK(worstRatio(std::array<double, 3>{0.05, -0.4, 0.1}, before, after, settings) == 2);
    CHECK(worstRatio(std::array<double, 3>{0.05, -0.4, 3}, before, after, settings) == 3);
    CHECK(std::isinf(worstRatio(std::array<double, 3>{0, NAN, 0}, before, after, settings)));
    CHECK(std::isinf(
        worstRatio(std::array<double, 1>{0}, std::array<double, 1>{0}, std::array<double, 1>{INFINITY}, settings)));
    const AdaptiveSettings relative{.absoluteTolerance = 0};
    CHECK(worstRatio(std::array<double, 1>{0}, std::array<double, 1>{0}, std::array<double, 1>{0}, relative) == 0);
}

TEST_CASE("tolerances and steps that mean nothing are refused by name", "[integrate]") {
    const auto refused = [](const AdaptiveSettings& settings, const std::string& text) {
        CHECK_THROWS_WITH(requireSettings(settings), text);
    };
    refused({.absoluteTolerance = -1}, "AdaptiveSettings.absoluteTolerance: -1 is negative");
    refused({.relativeTolerance = NAN}, "AdaptiveSettings.relativeTolerance: nan is not finite");
    refused({.absoluteTolerance = 0, .relativeTolerance = 0},
            "AdaptiveSettings.relativeTolerance: 0 is not positive, nor is absoluteTolerance");
    refused({.firstStep = -1}, "AdaptiveSettings.firstStep: -1 is negative");
    refused({.maxStep = INFINITY}, "AdaptiveSettings.maxStep: inf is not finite");
    refused({.maxSteps = 0}, "AdaptiveSettings.maxSteps: 0 is not positive");
}
