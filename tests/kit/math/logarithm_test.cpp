// SPDX-License-Identifier: MIT
#include <plumb/math/logarithm.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>

#include "catch.h"
#include "kit/math/reference.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

struct WorstUlps {
    double ulps = 0, at = 0;
    void hold(double x, double value, long double exact) {
        int exponent = 0;
        std::frexp(exact, &exponent);
        const double error =
            static_cast<double>(std::fabs(value - exact)) / std::ldexp(1.0, std::max(exponent - 53, -1074));
        if (error > ulps) {
            ulps = error;
            at = x;
        }
    }
};

}  // namespace

TEST_CASE("a million logarithms are within 1 ulp, and with 1 added first", "[math][trig]") {
    Random random(23);
    WorstUlps plain, plus;
    for (int i = 0; i < million; ++i) {
        const int kind = random.integer(0, 3);
        // Every magnitude; 0 to 3; close to 1 or 0, closer and closer.
        const double wide = std::exp2(random.uniform(-1070, 1023));
        const double close = random.uniform(-1, 1) * std::exp2(random.uniform(-52, 0));
        const double x = kind == 0 ? wide : kind == 1 ? random.uniform(0x1p-30, 3) : 1 + close;
        if (x > 0) plain.hold(x, logarithm(x), std::log(static_cast<long double>(x)));
        const double y = kind == 0 ? wide : kind == 1 ? random.uniform(-0.999, 3) : close;
        if (y > -1) plus.hold(y, logarithm1Plus(y), std::log1p(static_cast<long double>(y)));
    }
    std::cout << "logarithm: " << plain.ulps << " ulp at " << plain.at << "; of 1 plus: " << plus.ulps << " ulp at "
              << plus.at << '\n';
    CHECK(plain.ulps < 1 + own);
    CHECK(plus.ulps < 1 + own);
}

TEST_CASE("a logarithm undoes an exponential to 4 ulp at 100,000 numbers", "[math][trig]") {
    Random random(29);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double x = random.uniform(1, 700);
        worst = std::max(worst, std::fabs(logarithm(exponential(x)) - x) / x);
    }
    // 1 ulp of e^x is 2.2e-16 of it at most, as much of x + ln, and x >= 1; then 1 ulp of the logarithm.
    CHECK(worst < 4 * 2.3e-16);
}

TEST_CASE("logarithms at 1, at the ends of the range and of values that have none", "[math][trig]") {
    CHECK(logarithm(1) == 0);
    CHECK(logarithm1Plus(0) == 0);
    CHECK(logarithm(2) == 0x1.62e42fefa39efp-1);
    CHECK(logarithm1Plus(1) == 0x1.62e42fefa39efp-1);
    CHECK(logarithm(5e-324) == -744.4400719213812);
    CHECK(logarithm(1.7976931348623157e308) == 709.782712893384);
    CHECK(logarithm1Plus(1.7976931348623157e308) == 709.782712893384);
    for (const double tiny : {5e-324, -5e-324, 1e-300, -1e-17}) CHECK(logarithm1Plus(tiny) == tiny);
    CHECK(logarithm(0) == -infinity);
    CHECK(logarithm(-0.0) == -infinity);
    CHECK(logarithm1Plus(-1) == -infinity);
    CHECK(logarithm(infinity) == infinity);
    CHECK(logarithm1Plus(infinity) == infinity);
    for (const double bad : {-5e-324, -1.0, -infinity, test::nan}) CHECK(std::isnan(logarithm(bad)));
    for (const double bad : {-1.0000000000000002, -infinity, test::nan}) CHECK(std::isnan(logarithm1Plus(bad)));
}
