// SPDX-License-Identifier: MIT
#include <compare/lab/graph.h>

#include <cmath>
#include <vector>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {

TEST_CASE("3 x^1.5 has the exponent 1.5, and a point that is none of it bends it", "[compare][lab]") {
    std::vector<Point> points;
    for (double x = 1; x <= 1024; x *= 2) points.push_back({x, 3 * std::pow(x, 1.5)});
    CHECK(std::fabs(*exponent(points) - 1.5) < 1e-14);
    points.back().y *= 2;
    // The last of eleven points lies 5 from the middle, in powers of 2; the squares of all sum up to 110.
    CHECK(std::fabs(*exponent(points) - (1.5 + 5.0 / 110)) < 1e-14);
}

TEST_CASE("what has no logarithm is left out, and fewer than two places have no exponent", "[compare][lab]") {
    const std::vector<Point> points{{0, 1}, {1, 1}, {2, 0}, {3, nan}, {4, 16}, {infinity, 1}, {-1, 1}};
    CHECK(std::fabs(*exponent(points) - 2) < 1e-14);
    CHECK_FALSE(exponent(std::vector<Point>{}));
    CHECK_FALSE(exponent(std::vector<Point>{{2, 1}}));
    CHECK_FALSE(exponent(std::vector<Point>{{2, 1}, {2, 3}}));
}

}  // namespace plumb::compare
