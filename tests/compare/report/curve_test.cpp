// SPDX-License-Identifier: MIT
#include <compare/report/curve.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double noPoint = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a curve of 4,000 ticks keeps every tick, and one of 100,000 has 4,000 points at most", "[compare][report]") {
    CHECK(curveStride(4000, 4000) == 1);
    const std::vector<double> series(100'000, 1.0);
    const std::size_t stride = curveStride(series.size(), 4000);
    CHECK(stride == 50);
    CHECK(thinned(series, stride).size() == 4000);
    CHECK(thinned(series, 1) == series);
}

TEST_CASE("a peak and a dip of one tick in 100,000 stay in the curve", "[compare][report]") {
    std::vector<double> series(100'000, 1.0);
    series[31'415] = 7;
    series[92'653] = -7;
    const std::vector<double> points = thinned(series, 50);
    CHECK(std::ranges::count(points, 7) == 1);
    CHECK(std::ranges::count(points, -7) == 1);
    CHECK(std::ranges::count(points, 1) == 3998);
}

TEST_CASE("of the two extremes the one that came first is drawn first", "[compare][report]") {
    const std::vector<double> series{3, 5, 1, 2, 2, 9, 8, 4};
    CHECK(thinned(series, 4) == std::vector<double>{5, 1, 2, 9});
}

TEST_CASE("where nothing is known the curve has a gap, and nowhere else", "[compare][report]") {
    const std::vector<double> series{noPoint, 2, noPoint, 1, noPoint, noPoint, noPoint, noPoint, 4};
    const std::vector<double> points = thinned(series, 4);
    REQUIRE(points.size() == 6);
    CHECK(points[0] == 2);
    CHECK(points[1] == 1);
    CHECK(std::isnan(points[2]));
    CHECK(std::isnan(points[3]));
    CHECK(points[4] == 4);
    CHECK(points[5] == 4);
}

}  // namespace plumb::compare
