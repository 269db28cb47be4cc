// SPDX-License-Identifier: MIT
#include <plumb/movers/path_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"
#include "kit/movers/long_points.h"
#include "numbers.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// By de Casteljau's corners cut, in long double.
LongPoint onCurve(const Curve& curve, Real u) {
    std::array<LongPoint, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = real(curve[i]);
    for (std::size_t left = 3; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i) points[i] = (1 - u) * points[i] + u * points[i + 1];
    return points[0];
}

double sizeOf(const Curve& c) {
    return (c[1] - c[0]).norm() + (c[2] - c[1]).norm() + (c[3] - c[2]).norm();
}

/// Lengths from the start to each corner of a polyline on the curve.
std::vector<Real> polylineOn(const Curve& curve, int edges) {
    std::vector<Real> lengths{0};
    LongPoint last = onCurve(curve, 0);
    for (int i = 1; i <= edges; ++i) {
        const LongPoint next = onCurve(curve, static_cast<Real>(i) / edges);
        lengths.push_back(lengths.back() + distance(last, next));
        last = next;
    }
    return lengths;
}

/// One in four with two points in one place, or a cusp.
Curve randomCurve(Random& random) {
    Curve curve;
    for (Vec2& point : curve) point = {random.uniform(-10, 10), random.uniform(-10, 10)};
    const int kind = random.integer(0, 15);
    if (kind == 0) curve[1] = curve[0];
    if (kind == 1) curve[2] = curve[3];
    if (kind == 2) curve[2] = curve[0] + (curve[3] - curve[1]);               // crosses or comes to a point
    if (kind == 3) curve = {Vec2(0, 0), Vec2(1, 1), Vec2(0, 1), Vec2(1, 0)};  // a cusp at 1/2
    return curve;
}

MotionPath pathOf(const Curve& curve) {
    MotionPath path(curve[0]);
    path.curveTo(curve[1], curve[2], curve[3]);
    return path;
}

}  // namespace

TEST_CASE("a path's lines and arcs are the closed forms: a stadium of 4 m and two half circles of 1 m", "[movers]") {
    MotionPath path({0, 0});
    path.lineTo({4, 0}).arcAround({4, 1}, pi).lineTo({0, 2}).arcAround({0, 1}, pi);
    CHECK(std::fabs(path.length() - (8 + 2 * pi)) < 1e-14);
    CHECK(path.closed());
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double s = path.length() * i / 1000;
        Vec2 place(0, 0), tangent(0, 0);
        if (s < 4) {
            place = {s, 0};
            tangent = {1, 0};
        } else if (s < 4 + pi) {
            const double angle = s - 4 - pi / 2;
            place = {4 + std::cos(angle), 1 + std::sin(angle)};
            tangent = {-std::sin(angle), std::cos(angle)};
        } else if (s < 8 + pi) {
            place = {4 - (s - 4 - pi), 2};
            tangent = {-1, 0};
        } else {
            const double angle = s - 8 - pi + pi / 2;
            place = {std::cos(angle), 1 + std::sin(angle)};
            tangent = {-std::sin(angle), std::cos(angle)};
        }
        const PathPlace point = path.at(s);
        worst = std::max({worst, (point.position - place).norm(), (point.tangent - tangent).norm()});
    }
    // A few roundings of numbers below 16: 2^-50 each.
    CHECK(worst < 8 * 0x1p-50);
    std::cout << "stadium against its closed form: at most " << worst << " m off\n";
}

TEST_CASE("a clockwise arc of three turns and a half is 7 pi long and ends opposite", "[movers]") {
    MotionPath path({1, 0});
    path.arcAround({0, 0}, -7 * pi);
    CHECK(std::fabs(path.length() - 7 * pi) < 1e-14);
    CHECK((path.end() - Vec2(-1, 0)).norm() < 1e-14);  // an angle of 22, rounded by 2^-49
    CHECK((path.at(pi / 2).position - Vec2(0, -1)).norm() < 1e-15);
    CHECK((path.at(0).tangent - Vec2(0, -1)).norm() < 1e-15);
}

TEST_CASE("the length of 1,000 random curves lies where polylines of 2,000 and 4,000 edges say, and so do its parts",
          "[movers]") {
    Random random(5);
    double worstLength = 0, worstPlace = 0;
    int smooth = 0;
    const int runs = cases(1000);
    for (int run = 0; run < runs; ++run) {
        const Curve curve = randomCurve(random);
        const MotionPath path = pathOf(curve);
        const double size = sizeOf(curve), slack = 1e-11 * size;
        const std::vector<Real> rough = polylineOn(curve, 1000), coarse = polylineOn(curve, 2000),
                                fine = polylineOn(curve, 4000);
        CAPTURE(run, size);
        for (const std::size_t at : {std::size_t{150}, std::size_t{500}, std::size_t{999}, std::size_t{1000}}) {
            // A polyline is shorter than its curve; of twice as many edges, by half as much or less even at a cusp.
            const Real low = fine[4 * at], gap = fine[4 * at] - coarse[2 * at];
            // Richardson, for what is smooth: what is left is a 15th of its own last change.
            const Real best = low + gap / 3, before = coarse[2 * at] + (coarse[2 * at] - rough[at]) / 3;
            const PathPlace place = path.at(static_cast<double>(best));
            const Real off = distance(real(place.position), onCurve(curve, static_cast<Real>(at) / 1000));
            REQUIRE(off <= slack + gap);
            if (at == 1000) REQUIRE(path.length() >= low - slack);
            if (at == 1000) REQUIRE(path.length() <= low + gap + slack);
            if (std::fabs(best - before) >= slack) continue;  // too sharp a bend for polylines to tell more
            REQUIRE(off <= 2 * slack);
            worstPlace = std::max(worstPlace, static_cast<double>(off / size));
            if (at < 1000) continue;
            REQUIRE(std::fabs(path.length() - best) <= 2 * slack);
            ++smooth;
            worstLength = std::max(worstLength, static_cast<double>(std::fabs(path.length() - best) / size));
        }
    }
    CHECK(smooth > runs / 2);
    std::cout << runs << " curves, of which polylines tell " << smooth << " to 1e-11: lengths off by at most "
              << worstLength << ", places by " << worstPlace << " of the size\n";
}

TEST_CASE("a straight curve of 3 m with its points in thirds is its line, one doubling back on itself is longer",
          "[movers]") {
    const MotionPath path = pathOf({Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(3, 0)});
    CHECK(std::fabs(path.length() - 3) < 1e-14);
    for (const double s : {0.0, 0.1, 1.7, 3.0}) CHECK((path.at(s).position - Vec2(s, 0)).norm() < 1e-11 * 3);
    // x = 3 u (1 - u): out to 3/4 and back, and at its turn it stands still.
    const MotionPath back = pathOf({Vec2(0, 0), Vec2(1, 0), Vec2(1, 0), Vec2(0, 0)});
    CHECK(std::fabs(back.length() - 1.5) < 1e-11 * 2);
    CHECK(back.closed());
    for (const double s : {0.1, 0.6, 0.74, 0.76, 1.2}) {
        CHECK((back.at(s).position - Vec2(s < 0.75 ? s : 1.5 - s, 0)).norm() < 1e-11 * 2);
        CHECK((back.at(s).tangent - Vec2(s < 0.75 ? 1 : -1, 0)).norm() < 1e-12);
    }
    // Even at the ends of a curve that begins and ends at rest there is a tangent.
    const MotionPath resting = pathOf({Vec2(0, 0), Vec2(0, 0), Vec2(2, 1), Vec2(2, 1)});
    CHECK((resting.at(0).tangent - Vec2(2, 1).normalized()).norm() < 1e-12);
    CHECK((resting.at(9).tangent - Vec2(2, 1).normalized()).norm() < 1e-12);
}

TEST_CASE("a parabola's length is its closed form: y = x^2 from 0 to 1, sqrt(5) / 2 + asinh(2) / 4", "[movers]") {
    // The quadratic through (0, 0), (1/2, 0), (1, 1), raised to a cubic.
    const MotionPath path = pathOf({Vec2(0, 0), Vec2(1.0 / 3, 0), Vec2(2.0 / 3, 1.0 / 3), Vec2(1, 1)});
    const double closed = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
    CHECK(std::fabs(path.length() - closed) < 1e-11 * 2);
    std::cout << "parabola's length: off by " << std::fabs(path.length() - closed) << " of " << closed << '\n';
}

TEST_CASE("unsound paths are refused by name, and stay as they were", "[movers]") {
    const double nan = std::nan("");
    CHECK_THROWS_WITH(MotionPath({nan, 0}), "MotionPath: start: (nan, 0) is not finite");
    MotionPath path({1, 2});
    CHECK_THROWS_WITH(path.at(0), "MotionPath.at: the path has no piece");
    CHECK_THROWS_WITH(path.lineTo({1, 2}), "MotionPath.lineTo: end: (1, 2) is where the path is already");
    CHECK_THROWS_AS(path.lineTo({infinity, 0}), std::invalid_argument);
    CHECK_THROWS_AS(path.lineTo({1e300, 0}), std::invalid_argument);  // its square has no end
    CHECK_THROWS_WITH(path.arcAround({1, 2}, 1), "MotionPath.arcAround: center: (1, 2) is where the path is");
    CHECK_THROWS_WITH(path.arcAround({0, 2}, 0), "MotionPath.arcAround: angle: 0 is no arc");
    CHECK_THROWS_AS(path.arcAround({0, 2}, nan), std::invalid_argument);
    CHECK_THROWS_AS(path.arcAround({0, nan}, 1), std::invalid_argument);
    CHECK_THROWS_AS(path.arcAround({0, 2}, 1e308 * 10), std::invalid_argument);
    CHECK_THROWS_AS(path.curveTo({1, 2}, {1, 2}, {1, 2}), std::invalid_argument);
    for (const double bad : {nan, infinity, 1e200, -1e200}) {
        CHECK_THROWS_AS(path.curveTo({bad, 0}, {1, 1}, {2, 2}), std::invalid_argument);
        CHECK_THROWS_AS(path.curveTo({0, 0}, {1, bad}, {2, 2}), std::invalid_argument);
        CHECK_THROWS_AS(path.curveTo({0, 0}, {1, 1}, {bad, 2}), std::invalid_argument);
    }
    CHECK(path.length() == 0);
    CHECK(path.end() == Vec2(1, 2));
    path.lineTo({2, 2});
    CHECK_THROWS_AS(path.at(nan), std::invalid_argument);
    CHECK(path.at(-7).position == Vec2(1, 2));
    CHECK(path.at(7).position == Vec2(2, 2));
    CHECK_THROWS_WITH(splineThrough({{0, 0}}), "splineThrough: points: 1 points are fewer than 2");
    CHECK_THROWS_AS(splineThrough({{0, 0}, {1, 0}}, true), std::invalid_argument);
    CHECK_THROWS_WITH(splineThrough({{0, 0}, {1, 0}, {1, 0}}), containsText("points[2]: (1, 0) is where"));
    CHECK_THROWS_WITH(splineThrough({{0, 0}, {1, 0}, {0, 0}}, true), containsText("points[0]: (0, 0) is where"));
    CHECK_THROWS_AS(splineThrough({{0, 0}, {nan, 0}}), std::invalid_argument);
}

TEST_CASE("close adds the line that is missing, and none to a path that has come round", "[movers]") {
    MotionPath path({0, 0});
    path.lineTo({3, 0}).lineTo({3, 4}).close();
    CHECK(path.length() == 12);
    CHECK(path.closed());
    path.close();
    CHECK(path.length() == 12);
    CHECK(path.at(3).tangent == Vec2(0, 1));  // at a corner, of what follows
    const MotionPath copy = path;
    path.lineTo({9, 9});
    CHECK(copy.length() == 12);
}
