// SPDX-License-Identifier: MIT
#include <plumb/shapes/shape.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "catch.h"

using namespace plumb;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

void check(const Shape& shape) {
    validate(shape, "BodyDef.shapes[1].shape");
}

// Corners at these angles [degrees] of an ellipse, seen from afar by shift.
Polygon onEllipse(const std::vector<double>& angles, const Vec2& halfAxes, const Vec2& shift = {0, 0}) {
    Polygon polygon;
    for (const double angle : angles) {
        const SinCos r = sinCos(angle * std::numbers::pi / 180);
        polygon.vertices.push_back(shift + Vec2(halfAxes.x() * r.cos, halfAxes.y() * r.sin));
    }
    return polygon;
}

}  // namespace

TEST_CASE("a box polygon has its corners where half its size puts them, counter-clockwise", "[shapes]") {
    const Polygon box = boxPolygon({2, 1}, {10, 20});
    REQUIRE(box.vertices.size() == 4);
    CHECK(box.vertices[0] == Vec2(8, 19));
    CHECK(box.vertices[1] == Vec2(12, 19));
    CHECK(box.vertices[2] == Vec2(12, 21));
    CHECK(box.vertices[3] == Vec2(8, 21));
    CHECK_NOTHROW(check(box));
}

TEST_CASE("segments of no length or no place are refused", "[shapes][errors]") {
    CHECK_NOTHROW(check(Segment{{0, 0}, {0, 1e-9}}));
    CHECK_THROWS_WITH(check(Segment{{3, 4}, {3, 4}}), "BodyDef.shapes[1].shape.end: (3, 4) is the same point as start");
    CHECK_THROWS_WITH(check(Segment{{notANumber, 4}, {3, 4}}), "BodyDef.shapes[1].shape.start: (nan, 4) is not finite");
    CHECK_THROWS_WITH(check(Segment{{3, 4}, {3, -infinity}}), "BodyDef.shapes[1].shape.end: (3, -inf) is not finite");
}

TEST_CASE("capsules without a length, a radius or a place are refused", "[shapes][errors]") {
    CHECK_NOTHROW(check(Capsule{}));
    CHECK_THROWS_WITH(check(Capsule{{1, 2}, {1, 2}, 1}),
                      "BodyDef.shapes[1].shape.end: (1, 2) is the same point as start: that is a circle");
    CHECK_THROWS_WITH(check(Capsule{{0, 0}, {1, 0}, 0}), "BodyDef.shapes[1].shape.radius: 0 is not positive");
    CHECK_THROWS_WITH(check(Capsule{{0, 0}, {1, 0}, infinity}), "BodyDef.shapes[1].shape.radius: inf is not finite");
    CHECK_THROWS_WITH(check(Capsule{{0, notANumber}, {1, 0}, 1}),
                      "BodyDef.shapes[1].shape.start: (0, nan) is not finite");
}

TEST_CASE("polygons of fewer than 3 or more than 64 corners are refused", "[shapes][errors]") {
    const std::string prefix = "BodyDef.shapes[1].shape.vertices: ";
    CHECK_THROWS_WITH(check(Polygon{}), prefix + "0 corners are fewer than 3");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 0}}}), prefix + "2 corners are fewer than 3");
    const auto evenly = [](int count) {
        std::vector<double> angles;
        for (int i = 0; i < count; ++i) angles.push_back(360.0 * i / count);
        return onEllipse(angles, {1, 1});
    };
    CHECK_THROWS_WITH(check(evenly(65)), prefix + "65 corners are more than 64");
    CHECK_NOTHROW(check(evenly(64)));
    CHECK_NOTHROW(check(evenly(8)));
}

TEST_CASE("polygons that are not convex and counter-clockwise are refused by the corner at fault", "[shapes][errors]") {
    const std::string prefix = "BodyDef.shapes[1].shape.vertices";
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 0}, {notANumber, 1}}}), prefix + "[2]: (nan, 1) is not finite");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {0, 1}, {1, 0}}}),
                      prefix + ": the corners run clockwise, not counter-clockwise");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}}}),
                      prefix + "[3]: (1, 0.5) makes the polygon not convex");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 0}, {2, 0}, {0, 1}}}),
                      prefix + "[1]: (1, 0) lies in line with the corners beside it");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {2, 0}, {1, 0}, {0, 1}}}),
                      prefix + "[1]: (2, 0) lies in line with the corners beside it");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}),
                      prefix + "[2]: (1, 0) repeats the corner before it");
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}),
                      prefix + "[0]: (0, 0) repeats the corner before it");
    CHECK_THROWS_WITH(check(Polygon{{{5, 5}, {5, 5}, {5, 5}}}), prefix + "[1]: (5, 5) repeats the corner before it");
    // A bow tie turns both ways.
    CHECK_THROWS_WITH(check(Polygon{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}),
                      prefix + "[1]: (1, 1) makes the polygon not convex");
}

TEST_CASE("stars turn left at every corner, but wind around more than once", "[shapes][errors]") {
    const std::string prefix = "BodyDef.shapes[1].shape.vertices: the corners wind around ";
    CHECK_THROWS_WITH(check(onEllipse({0, 144, 288, 72, 216}, {1, 1})), prefix + "2 times, not once");
    CHECK_THROWS_WITH(check(onEllipse({0, 135, 270, 45, 180, 315, 90, 225}, {1, 1})), prefix + "3 times, not once");
    CHECK_THROWS_WITH(check(onEllipse({10, 130, 250, 20, 140, 260}, {1, 1})), prefix + "2 times, not once");
}

TEST_CASE("a turn of 1e-5 and an edge of 1e-5 of the whole are taken, 1e-7 is refused", "[shapes][errors]") {
    // A flat roof of height h over half a width of 1: the turn at its ridge has a sine of 2 h.
    const auto roof = [](double h) { return Polygon{{{-1, 0}, {0, -1}, {1, 0}, {0, h}}}; };
    CHECK_NOTHROW(check(roof(1e-5)));
    CHECK_THROWS(check(roof(1e-7)));
    // A short edge, as part of the whole.
    const auto cut = [](double edge) { return Polygon{{{0, 0}, {1, 0}, {1, edge}, {0, 1}}}; };
    CHECK_NOTHROW(check(cut(1e-5)));
    CHECK_THROWS(check(cut(1e-7)));
}

TEST_CASE("polygons are taken at any size and place that doubles can tell apart", "[shapes][errors]") {
    for (const double size : {1e-300, 1e-30, 1e-3, 1.0, 1e6, 1e30, 1e300})
        CHECK_NOTHROW(check(onEllipse({0, 45, 90, 135, 180, 225, 270, 315}, {size, size})));
    CHECK_NOTHROW(check(onEllipse({0, 60, 120, 180, 240, 300}, {1, 1}, {1e7, -1e7})));
    CHECK_NOTHROW(check(onEllipse({0, 60, 120, 180, 240, 300}, {10'000, 1})));
    CHECK_THROWS(check(onEllipse({0, 120, 240}, {1e-9, 1e-9}, {1e9, 0})));  // one point, to a double
}

TEST_CASE("1,000 polygons on ellipses are taken as they are and refused turned over", "[shapes][errors]") {
    Random random(5);
    int taken = 0;
    int refused = 0;
    for (int round = 0; round < 1000; ++round) {
        const int count = random.integer(3, 64);
        std::vector<double> angles;
        const double start = random.uniform(0, 360);
        for (int i = 0; i < count; ++i) angles.push_back(start + (i + random.uniform(0, 0.8)) * 360 / count);
        Polygon polygon = onEllipse(angles, {1, random.uniform(0.05, 1)}, {random.uniform(-9, 9), 0});
        try {
            check(polygon);
            ++taken;
        } catch (const std::invalid_argument&) {
        }
        polygon.vertices = {polygon.vertices.rbegin(), polygon.vertices.rend()};
        try {
            check(polygon);
        } catch (const std::invalid_argument&) {
            ++refused;
        }
    }
    CHECK(taken == 1000);
    CHECK(refused == 1000);
}
