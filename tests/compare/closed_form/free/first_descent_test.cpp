// SPDX-License-Identifier: MIT
#include <compare/closed_form/free/first_descent.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("a polynomial's first fall through zero is found, and no rise", "[compare][closed_form]") {
    CHECK(firstDescent({2, -1}, 10).value() == 2);
    CHECK_FALSE(firstDescent({-2, 1}, 10));  // it rises
    CHECK_FALSE(firstDescent({2, -1}, 1));   // not in time
    CHECK(std::abs(firstDescent({-1, 0, 0}, 10).value_or(-1) + 1) < 1e-15);
    // Thrown up at 3 m/s from the ground: down again after 2 v / g.
    CHECK(std::abs(firstDescent({0, 3, -5}, 10).value() - 0.6) < 1e-15);
    // (t - 1) (t - 2) (t - 3) (t - 4): down at 1 and at 3.
    CHECK(std::abs(firstDescent({24, -50, 35, -10, 1}, 10).value() - 1) < 1e-12);
    // It starts below zero: the rise at 1 is none of them.
    CHECK(std::abs(firstDescent({-24, 50, -35, 10, -1}, 10).value() - 2) < 1e-12);
    CHECK_FALSE(firstDescent({1, 0, 0, 0, 1}, 10));
}

TEST_CASE("what has fallen through zero by rounding, and falls, does so now", "[compare][closed_form]") {
    CHECK(firstDescent({-1e-12, -1}, 10).value() == 0);
    CHECK_FALSE(firstDescent({-1e-3, -1}, 10));
    CHECK(std::abs(firstDescent({-1e-17, 2, -1}, 10).value() - 2) < 1e-12);  // it leaves, and comes back
}

}  // namespace plumb::compare
