// SPDX-License-Identifier: MIT
#include <plumb/shapes/bounding_circle.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

#include "cases.h"
#include "catch.h"
#include "kit/collide/placed_outline.h"
#include "kit/collide/placements.h"

namespace {

using minkowski::Outline;
using minkowski::Point;
using namespace plumb;
using namespace plumb::test;

double farthestFrom(Point center, const std::vector<Point>& points) {
    double farthest = 0;
    for (const Point p : points) farthest = std::max(farthest, length(p - center));
    return farthest;
}

/// The best of the circles around all pairs of points, and of those through all triples.
double smallestRadius(const std::vector<Point>& points) {
    double least = points.size() == 1 ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            least = std::min(least, farthestFrom((points[i] + points[j]) * 0.5, points));
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                // Equally far from i as from j and from k: two equations, by Cramer's rule.
                const Point ij = points[j] - points[i], ik = points[k] - points[i];
                const double det = 2 * cross(ij, ik), jj = dot(ij, ij), kk = dot(ik, ik);
                if (std::fabs(det) < 1e-12) continue;
                const Point from{(jj * ik.y - kk * ij.y) / det, (ij.x * kk - ik.x * jj) / det};
                least = std::min(least, farthestFrom(points[i] + from, points));
            }
        }
    return least;
}

}  // namespace

TEST_CASE("bounding circles hold 100,000 shapes, and are what all pairs and triples of corners make",
          "[shapes][bounds]") {
    Random random(131);
    double outside = 0, larger = 0, smaller = 0;
    const int count = cases(100'000);
    for (int i = 0; i < count; ++i) {
        const Shape shape = randomShape(random, randomKind(random), 1);
        const Transform pose{randomVec2(random, 3), turnBy(random.uniform(-3, 3))};
        const Outline outline = outlineOf(shape, pose);
        const BoundingCircle circle = boundingCircleOf(shape, pose);
        outside =
            std::max(outside, farthestFrom(pointOf(circle.center), outline.corners) + outline.radius - circle.radius);
        if (outline.corners.size() > 16) continue;  // triples are many
        const double best = smallestRadius(outline.corners) + outline.radius;
        larger = std::max(larger, circle.radius - best);
        smaller = std::max(smaller, best - circle.radius);
    }
    std::cout << "[bounds] " << count << " bounding circles: shapes stick out by " << outside
              << " m at most; larger than the best by " << larger << " m, smaller by " << smaller << " m\n";
    CHECK(outside < 8 * 8 * 1.2e-16);  // eight roundings of coordinates up to 8 m
    // A point that is 1e-14 of the radius outside counts as on the circle.
    CHECK(larger < 4e-14);
    CHECK(smaller < 4e-14);
}

TEST_CASE("the circle around a box is around its corners, around an obtuse triangle around its longest side",
          "[shapes][bounds]") {
    const BoundingCircle box = boundingCircleOf(boxPolygon({4, 3}), {{1, 2}, turnBy(0.4)});
    CHECK(std::fabs(box.radius - 5) < 2e-15);
    CHECK((box.center - Vec2(1, 2)).norm() < 2e-15);
    const BoundingCircle triangle = boundingCircleOf(Polygon{{{0, 0}, {10, 0}, {5, 1}}, 0.5});
    CHECK(triangle.center == Vec2(5, 0));
    CHECK(triangle.radius == 5.5);
    CHECK(boundingCircleOf(Circle{2, {1, 1}}).radius == 2);
    CHECK(boundingCircleOf(Chain{.points = {{0, 0}, {1, 0}, {2, 0}}}).radius == 1);
}

TEST_CASE("circles of points: in one place, on a circle, 100,000 of them, none", "[shapes][bounds]") {
    const std::vector<Vec2> one(3, Vec2(7, 8));
    CHECK(boundingCircleOf(one).center == Vec2(7, 8));
    CHECK(boundingCircleOf(one).radius == 0);
    std::vector<Vec2> rim, cloud;
    Random random(137);
    for (int i = 0; i < 10'000; ++i) rim.push_back(turnBy(0.001 * i) * Vec2(3, 0) + Vec2(1, -1));
    CHECK(std::fabs(boundingCircleOf(rim).radius - 3) < 1e-13);
    for (int i = 0; i < 100'000; ++i) cloud.push_back(randomVec2(random, 1));
    const BoundingCircle circle = boundingCircleOf(cloud);
    CHECK(circle.radius <= std::sqrt(2));
    CHECK(circle.radius > 1.4);
    const std::vector<Vec2> bad{{0, 0}, {0, NAN}};
    CHECK_THROWS_WITH(boundingCircleOf(bad), "boundingCircleOf.points[1]: (0, nan) is not finite");
    CHECK_THROWS_WITH(boundingCircleOf(std::span<const Vec2>()), "boundingCircleOf.points: there are none");
}

TEST_CASE("bounding circles overlap when their distance says so, touching included", "[shapes][bounds]") {
    const BoundingCircle circle{{0, 0}, 1};
    CHECK(overlap(circle, {{3, 4}, 4}));
    CHECK_FALSE(overlap(circle, {{3, 4}, 3.999}));
    CHECK_FALSE(overlap(circle, {{NAN, 0}, 3}));
    CHECK(contains(circle, {0.6, 0.8}));
    CHECK_FALSE(contains(circle, {0.61, 0.8}));
    Random random(139);
    int wrong = 0;
    for (int i = 0; i < 100'000; ++i) {
        const BoundingCircle a{randomVec2(random, 2), random.uniform(0, 1)},
            b{randomVec2(random, 2), random.uniform(0, 1)};
        const double gap = length(pointOf(b.center) - pointOf(a.center)) - a.radius - b.radius;
        if (std::fabs(gap) > 1e-14) wrong += overlap(a, b) != (gap < 0);
    }
    CHECK(wrong == 0);
}
