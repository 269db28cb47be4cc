// SPDX-License-Identifier: MIT
#include <plumb/shapes/oriented_box.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "cases.h"
#include "catch.h"
#include "kit/collide/placed_outline.h"
#include "kit/collide/placements.h"

namespace {

using minkowski::Outline;
using minkowski::Point;
using namespace plumb;
using namespace plumb::test;

double areaOfBox(const OrientedBox& box) {
    return 4 * box.halfSize.x() * box.halfSize.y();
}

/// Of the box around an outline whose axis is at this angle.
double areaAt(const Outline& outline, double angle) {
    const auto widthAlong = [&](Point direction) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Point p : outline.corners) {
            low = std::min(low, dot(direction, p));
            high = std::max(high, dot(direction, p));
        }
        return high - low + 2 * outline.radius;
    };
    const Point along{std::cos(angle), std::sin(angle)};
    return widthAlong(along) * widthAlong({-along.y, along.x});
}

/// By how much the outline sticks out of the box.
double outsideOfBox(const OrientedBox& box, const Outline& outline) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point p : outline.corners) {
        const Vec2 local = box.rotation.inverse() * Vec2(Vec2(p.x, p.y) - box.center);
        most = std::max(most, (local.cwiseAbs() - box.halfSize).maxCoeff() + outline.radius);
    }
    return most;
}

OrientedBox anyBox(Random& random) {
    const double angle = random.integer(0, 3) * (std::numbers::pi / 4) + random.integer(0, 1) * random.uniform(-1, 1);
    OrientedBox box{randomVec2(random, 2), {0, 0}, turnBy(angle)};
    for (const int axis : {0, 1}) box.halfSize[axis] = random.integer(0, 9) ? random.uniform(0, 1.5) : 0;
    return box;
}

Outline outlineOfBox(const OrientedBox& box) {
    Outline outline;
    for (const Vec2& corner : cornersOf(box)) outline.corners.push_back(pointOf(corner));
    return outline;
}

}  // namespace

TEST_CASE("oriented boxes hold 100,000 shapes, and no angle of 1,000 gives a smaller one", "[shapes][bounds]") {
    Random random(109);
    double worst = 0, sharpest = 0;
    int smaller = 0, loose = 0;
    const int count = cases(100'000);
    for (int i = 0; i < count; ++i) {
        const Shape shape = randomShape(random, randomKind(random), 1);
        const Transform pose{randomVec2(random, 3), turnBy(random.uniform(-3, 3))};
        const Outline outline = outlineOf(shape, pose);
        const OrientedBox box = orientedBoxOf(shape, pose);
        worst = std::max(worst, std::fabs(outsideOfBox(box, outline)));  // touched from within, too
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 1000; ++k) least = std::min(least, areaAt(outline, k * std::numbers::pi / 2000));
        // Areas up to 40 m^2, to some roundings.
        smaller += least < areaOfBox(box) - 1e-13;
        // Between two angles, 0.0016 rad apart, a side changes by no more than that times the other.
        loose += least > areaOfBox(box) + 0.0008 * 2 * 40;
        sharpest = std::max(sharpest, areaOfBox(box) - least);
    }
    std::cout << "[bounds] " << count << " oriented boxes: off their shapes by " << worst
              << " m at most; larger than the best of 1,000 angles by " << sharpest << " m^2 at most\n";
    // Eight roundings of coordinates up to 8 m.
    CHECK(worst < 8 * 8 * 1.2e-16);
    CHECK(smaller == 0);
    CHECK(loose == 0);
}

TEST_CASE("a box around a turned box is that box, around a capsule its length by its width", "[shapes][bounds]") {
    for (const double angle : {0.0, 0.3, 1.2, 2.0, -0.7}) {
        const OrientedBox box = orientedBoxOf(boxPolygon({2, 1}), {{3, 4}, turnBy(angle)});
        CHECK((box.center - Vec2(3, 4)).norm() < 2e-15);
        CHECK(std::fabs(box.halfSize.maxCoeff() - 2) < 2e-15);
        CHECK(std::fabs(box.halfSize.minCoeff() - 1) < 2e-15);
        const OrientedBox capsule = orientedBoxOf(Capsule{{-2, 0}, {2, 0}, 0.5}, {{0, 0}, turnBy(angle)});
        CHECK(std::fabs(areaOfBox(capsule) - 5) < 1e-14);
    }
    // A triangle of sides 3, 4, 5: along the longest it is 5 by 2.4, along the others 4 by 3; all 12 m^2.
    CHECK(std::fabs(areaOfBox(orientedBoxOf(Polygon{{{0, 0}, {4, 0}, {0, 3}}})) - 12) < 1e-14);
}

TEST_CASE("boxes of points: in line, in one place, many, none", "[shapes][bounds]") {
    const std::vector<Vec2> line{{0, 0}, {3, 4}, {1.5, 2}}, one{{7, 8}, {7, 8}, {7, 8}};
    CHECK(std::fabs(orientedBoxOf(line).halfSize.maxCoeff() - 2.5) < 1e-15);
    CHECK(orientedBoxOf(line).halfSize.minCoeff() < 1e-15);
    CHECK(orientedBoxOf(one).center == Vec2(7, 8));
    CHECK(orientedBoxOf(one).halfSize == Vec2(0, 0));
    CHECK(orientedBoxOf(std::span(one).first(1)).center == Vec2(7, 8));
    Random random(113);
    std::vector<Vec2> cloud;
    for (int i = 0; i < 10'000; ++i) cloud.push_back(randomVec2(random, 1));
    const OrientedBox box = orientedBoxOf(cloud);
    CHECK(areaOfBox(box) < 4);
    CHECK(areaOfBox(box) > 3.9);
    const std::vector<Vec2> bad{{0, 0}, {NAN, 0}};
    CHECK_THROWS_WITH(orientedBoxOf(bad), "orientedBoxOf.points[1]: (nan, 0) is not finite");
    CHECK_THROWS_WITH(orientedBoxOf(std::span<const Vec2>()), "orientedBoxOf.points: there are none");
    for (const double size : {1e-320, 1e-200, 1e140, 1e155, 1e300}) {
        const OrientedBox extreme = orientedBoxOf(boxPolygon({size, size}));
        CHECK(extreme.halfSize.maxCoeff() >= size);
    }
}

TEST_CASE("oriented boxes overlap when the distance of their polygons says so, 1,000,000 times", "[shapes][bounds]") {
    Random random(127);
    int wrong = 0, overlapping = 0;
    const int count = cases(1'000'000);
    for (int i = 0; i < count; ++i) {
        const OrientedBox a = anyBox(random), b = anyBox(random);
        const double gap = gapBetween(outlineOfBox(a), outlineOfBox(b)).separation;
        const bool found = overlap(a, b);
        overlapping += found;
        if (std::fabs(gap) > 1e-14) wrong += found != (gap < 0);  // ten roundings of numbers up to 6
    }
    CHECK(wrong == 0);
    CHECK(overlapping > count / 10);
    CHECK(count - overlapping > count / 10);
    const OrientedBox box{{0, 0}, {1, 1}, {}};
    CHECK(overlap(box, {{2, 2}, {1, 1}, {}}));  // corner to corner they touch
    CHECK_FALSE(overlap(box, {{2.001, 2}, {1, 1}, {}}));
    CHECK_FALSE(overlap(box, {{NAN, 0}, {1, 1}, {}}));
    CHECK(contains(box, {1, -1}));
    CHECK_FALSE(contains(box, {1.001, 0}));
    CHECK_FALSE(contains(OrientedBox{{0, 0}, {1, 0.1}, turnBy(1)}, {0.9, 0}));
}
