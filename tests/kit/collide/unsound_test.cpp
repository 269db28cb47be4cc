// SPDX-License-Identifier: MIT
// What do questions about two shapes say of shapes that no body can have?
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <plumb/collide/bisection.h>
#include <plumb/collide/convex.h>
#include <plumb/collide/distance.h>
#include <plumb/collide/moving_circles.h>
#include <plumb/collide/overlap.h>
#include <plumb/collide/ray_cast.h>
#include <plumb/collide/shape_cast.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/bounding_circle.h>
#include <plumb/shapes/chain.h>
#include <plumb/shapes/oriented_box.h>

#include "catch.h"
#include "numbers.h"

namespace {

using namespace plumb;
using namespace plumb::test;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

Polygon evenly(int corners) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        polygon.vertices.push_back({std::cos(angle), std::sin(angle)});
    }
    return polygon;
}

struct Unsound {
    const char* name;
    Shape shape;
};

/// Those that arithmetic would read or write beyond.
std::vector<Unsound> miscounted() {
    return {{"a chain of no point", Chain{}},
            {"a chain of 1 point", Chain{{{0, 0}}}},
            {"a closed chain of 2 points", Chain{{{0, 0}, {1, 0}}, true}},
            {"a polygon of no corner", Polygon{}},
            {"a polygon of 2 corners", Polygon{{{0, 0}, {1, 0}}}},
            {"a 65-gon", evenly(65)},
            {"a 300-gon", evenly(300)}};
}

/// And those of which it would tell a lie.
std::vector<Unsound> unsound() {
    std::vector<Unsound> shapes = miscounted();
    shapes.push_back({"a circle of radius -1", Circle{-1}});
    shapes.push_back({"a circle of radius nan", Circle{notANumber}});
    shapes.push_back({"a circle at infinity", Circle{1, {infinity, 0}}});
    shapes.push_back({"a box that runs clockwise", Polygon{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}});
    shapes.push_back({"a dart", Polygon{{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}}}});
    shapes.push_back({"a capsule of no length", Capsule{{1, 0}, {1, 0}, 1}});
    shapes.push_back({"a segment of no length", Segment{{1, 0}, {1, 0}}});
    shapes.push_back({"a chain that stands still", Chain{{{0, 0}, {0, 0}, {1, 0}}}});
    return shapes;
}

const Circle disc{0.5};

}  // namespace

TEST_CASE("no question about two shapes crashes on an empty chain or a 300-gon: it is refused", "[collide][shapes]") {
    for (const Unsound& bad : miscounted()) {
        INFO(bad.name);
        CHECK_THROWS_AS(distance(bad.shape, {}, disc, {}), std::invalid_argument);
        CHECK_THROWS_AS(distance(disc, {}, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(castShape(bad.shape, {}, {1, 0}, disc, {}), std::invalid_argument);
        CHECK_THROWS_AS(castShape(disc, {}, {1, 0}, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(castRay({-9, 0.1}, {9, 0.1}, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(castRay({0, 0}, {0, 0}, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(convexOf(bad.shape, {0, 0}), std::invalid_argument);
        CHECK_THROWS_AS(aabbOf(bad.shape, {}), std::invalid_argument);
        if (std::holds_alternative<Chain>(bad.shape)) CHECK_THROWS_AS(piecesOf(bad.shape), std::invalid_argument);
    }
    CHECK_THROWS_WITH(distance(disc, {}, evenly(300), {}), "Polygon.vertices: 300 corners are more than 64");
    CHECK_THROWS_WITH(castRay({0, 0}, {1, 0}, Chain{}, {}), "Chain.points: 0 points are fewer than 2");
    CHECK_THROWS_WITH(piecesOf(Chain{{{0, 0}, {1, 0}}, true}),
                      "Chain.points: 2 points are fewer than 3 of a closed chain");
}

TEST_CASE("a sweep makes up no touch with an empty polygon, nor an overlap with a dart: they are refused",
          "[collide][sweep][overlap]") {
    const Sweep sweep{.start = {-8, 0}, .shift = {16, 0}};
    for (const Unsound& bad : unsound()) {
        INFO(bad.name);
        // Also far away, where nobody would look at it.
        for (const double x : {0.0, 100.0}) {
            CHECK_THROWS_AS(overlap(bad.shape, {}, disc, {{x, 0}, {}}), std::invalid_argument);
            CHECK_THROWS_AS(overlap(disc, {{x, 0}, {}}, bad.shape, {}), std::invalid_argument);
        }
        CHECK_THROWS_AS(firstTouch(bad.shape, sweep, disc, {}), std::invalid_argument);
        CHECK_THROWS_AS(firstTouch(disc, sweep, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(bisectCollision(bad.shape, sweep, disc, {}), std::invalid_argument);
        CHECK_THROWS_AS(bisectCollision(disc, sweep, bad.shape, {}), std::invalid_argument);
        CHECK_THROWS_AS(boundingCircleOf(bad.shape), std::invalid_argument);
        CHECK_THROWS_AS(orientedBoxOf(bad.shape), std::invalid_argument);
    }
    CHECK_THROWS_WITH(overlap(Chain{}, {}, disc, {}), "overlap.a.points: 0 points are fewer than 2");
    CHECK_THROWS_WITH(firstTouch(disc, sweep, Polygon{}, {}), "firstTouch.b.vertices: 0 corners are fewer than 3");
    CHECK_THROWS_WITH(bisectCollision(Circle{-1}, sweep, disc, {}), "bisectCollision.a.radius: -1 is not positive");
}

TEST_CASE("bisection on a way that is not a number is no miss: it is refused", "[collide][sweep]") {
    CHECK_THROWS_WITH(bisectCollision(disc, {.start = {notANumber, 0}}, disc, {}),
                      "bisectCollision.sweepA.start: (nan, 0) is not finite");
    CHECK_THROWS_WITH(bisectCollision(disc, {}, disc, {.angle = infinity}),
                      "bisectCollision.sweepB.angle: inf is not finite");
}

TEST_CASE("a ray that is not finite, or at a shape whose place is not, meets nothing", "[collide]") {
    const std::vector<Shape> shapes{disc,      boxPolygon({1, 1}),        Polygon{boxPolygon({1, 1}).vertices, 0.1},
                                    Capsule{}, Segment{{-1, -1}, {1, 1}}, Chain{{{-1, -1}, {1, 1}, {2, 0}}}};
    for (const double bad : {notANumber, infinity, -infinity})
        for (const Shape& shape : shapes)
            for (const Vec2& point : {Vec2(bad, 0), Vec2(0.1, bad), Vec2(bad, bad)}) {
                CHECK_FALSE(castRay(point, {1, 0}, shape, {}));
                CHECK_FALSE(castRay({-3, 0.1}, point, shape, {}));
                CHECK_FALSE(castRay(point, point, shape, {}));
                CHECK_FALSE(castRay({-3, 0.1}, {3, 0.2}, shape, {point, {}}));
                CHECK_FALSE(castRay({-3, 0.1}, {3, 0.2}, shape, {{0, 0}, {bad, bad}}));
                CHECK_FALSE(castShape(disc, {point, {}}, {1, 0}, shape, {}));
                CHECK_FALSE(castShape(disc, {}, {1, 0}, shape, {point, {}}));
                CHECK_FALSE(std::isfinite(distance(disc, {point, {}}, shape, {}).separation));
            }
}

// Their squares overflow: a nearest corner is never found.
TEST_CASE("two boxes 1e200 m apart are that far from each other, and do not touch", "[collide]") {
    const Shape box = boxPolygon({1, 1});
    for (const double far : {1e100, 1e153, 1e160, 1e200, 1e300})
        for (const Shape& other : {box, Shape(disc)}) {
            const Distance apart = distance(box, {}, other, {{far, 0}, {}});
            CHECK(std::fabs(apart.separation / far - 1) < 1e-15);
            CHECK(apart.normal == Vec2(1, 0));
        }
}

// Squares of ways above 1e154 overflow.
TEST_CASE("a shot shifted by 1e300 m touches no window 8 m away that it flies from: it is refused",
          "[collide][sweep]") {
    const Shape bullet = Circle{0.01}, window = boxPolygon({0.05, 1});
    const auto shot = [&](double shift) { return firstTouch(bullet, {{-8, 0}, {shift, 0}}, window, {}); };
    CHECK_THROWS_WITH(shot(1e300), "firstTouch.sweepA.shift: 1e+300 is not within -1e+75 to 1e+75");
    CHECK_THROWS_WITH(shot(-1e155), "firstTouch.sweepA.shift: -1e+155 is not within -1e+75 to 1e+75");
    CHECK_THROWS_AS(firstTouch(bullet, {}, window, {.turn = 1e160}), std::invalid_argument);
    CHECK_THROWS_AS(firstTouch(bullet, {}, window, {.localCenter = {0, 1e160}}), std::invalid_argument);
    CHECK_THROWS_WITH(firstTouch(bullet, {{-8, 0}, {16, 0}}, Circle{1, {1e80, 0}}, {}),
                      "firstTouch.b: box.lower: 1e+80 is not within -1e+75 to 1e+75");
    CHECK_THROWS_AS(firstTouch(MovingCircle{1, {0, 0}, {1e300, 0}}, MovingCircle{1, {3, 0}}), std::invalid_argument);
    for (const double shift : {1e3, 1e20, 1e75}) {
        CHECK_FALSE(shot(-shift));
        const auto touch = shot(shift);
        REQUIRE(touch);
        // The surfaces are 7.94 m apart; the touch is told when they are within 1e-5 m.
        CHECK(std::fabs(touch->time * shift - 7.94) < 1.01e-5);
        const auto circles = firstTouch(MovingCircle{0.01, {-8, 0}, {shift, 0}}, MovingCircle{0.05});
        REQUIRE(circles);
        CHECK(std::fabs(circles->time * shift - 7.94) < 1e-14);
    }
}
