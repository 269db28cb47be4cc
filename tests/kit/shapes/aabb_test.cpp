// SPDX-License-Identifier: MIT
#include <plumb/shapes/aabb.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <plumb/math/random.h>

#include "catch.h"

using namespace plumb;

namespace {

Transform somePose(Random& random) {
    return {{random.uniform(-50, 50), random.uniform(-50, 50)}, Rot::fromAngle(random.uniform(-3, 3))};
}

// How far the box around these points, in the world, is from another.
double distance(const Aabb& box, const std::vector<Vec2>& points) {
    Vec2 lower = points.front();
    Vec2 upper = points.front();
    for (const Vec2& p : points) {
        lower = {std::min(lower.x(), p.x()), std::min(lower.y(), p.y())};
        upper = {std::max(upper.x(), p.x()), std::max(upper.y(), p.y())};
    }
    return std::max((box.lower - lower).cwiseAbs().maxCoeff(), (box.upper - upper).cwiseAbs().maxCoeff());
}

// As the pose's two parts say, with the C library's sine and cosine.
Vec2 placed(double angle, const Vec2& position, const Vec2& local) {
    return {position.x() + local.x() * std::cos(angle) - local.y() * std::sin(angle),
            position.y() + local.x() * std::sin(angle) + local.y() * std::cos(angle)};
}

}  // namespace

TEST_CASE("the box of a polygon or a segment is the box of its corners, at 1,000 poses", "[shapes][aabb]") {
    Random random(41);
    double worst = 0;
    for (int round = 0; round < 1000; ++round) {
        const double angle = random.uniform(-9, 9);
        const Vec2 position(random.uniform(-50, 50), random.uniform(-50, 50));
        const Transform pose{position, Rot::fromAngle(angle)};
        const Polygon triangle{{{-1, -2}, {3, 0}, {0.5, 4}}};
        const Segment segment{{-2, 1}, {3, -4}};
        std::vector<Vec2> corners;
        for (const Vec2& v : triangle.vertices) corners.push_back(placed(angle, position, v));
        worst = std::max(worst, distance(aabbOf(triangle, pose), corners));
        worst = std::max(worst, distance(aabbOf(segment, pose), {placed(angle, position, segment.start),
                                                                 placed(angle, position, segment.end)}));
    }
    // Coordinates below 64 have last places of 7e-15; two sums each.
    CHECK(worst < 2 * 7.2e-15);
}

TEST_CASE("the box of a circle holds its rim and touches it on four sides, at 100 poses", "[shapes][aabb]") {
    Random random(43);
    for (int round = 0; round < 100; ++round) {
        const Transform pose = somePose(random);
        const Circle circle{.radius = random.uniform(0.1, 5), .center = {random.uniform(-9, 9), 3}};
        std::vector<Vec2> rim;
        const int count = 4000;
        for (int i = 0; i < count; ++i) {
            const double angle = i * 2 * std::numbers::pi / count;
            rim.push_back(pose * Vec2(circle.center + circle.radius * Vec2(std::cos(angle), std::sin(angle))));
        }
        // The point of the rim nearest to a side is at most half a step from touching it: r (1 - cos(pi / count)).
        const double gap = circle.radius * (1 - std::cos(std::numbers::pi / count));
        CHECK(distance(aabbOf(circle, pose), rim) < gap + 3 * 7.2e-15);
    }
}

TEST_CASE("the box of a capsule or a rounded polygon is that of its core and its radius, of a chain that of its points",
          "[shapes][aabb]") {
    Random random(45);
    double worst = 0;
    for (int round = 0; round < 1000; ++round) {
        const Transform pose = somePose(random);
        Polygon polygon{{{-1, -2}, {3, 0}, {0.5, 4}}};
        const double r = random.uniform(0.1, 2);
        const auto differ = [&](const Aabb& a, const Aabb& b) {
            worst = std::max({worst, (a.lower - b.lower).norm(), (a.upper - b.upper).norm()});
        };
        const Aabb sharp = aabbOf(polygon, pose);
        differ(aabbOf(Chain{polygon.vertices, true}, pose), sharp);
        polygon.radius = r;
        // A disc of that radius around every corner.
        Aabb discs = aabbOf(Circle{r, polygon.vertices[0]}, pose);
        for (const Vec2& v : polygon.vertices) discs = merge(discs, aabbOf(Circle{r, v}, pose));
        differ(aabbOf(polygon, pose), discs);
        const Aabb ends = merge(aabbOf(Circle{r, {-1, -2}}, pose), aabbOf(Circle{r, {3, 0}}, pose));
        differ(aabbOf(Capsule{{-1, -2}, {3, 0}, r}, pose), ends);
    }
    CHECK(worst < 2 * 7.2e-15);
}

TEST_CASE("boxes overlap when they touch, and hold themselves", "[shapes][aabb]") {
    const Aabb box{{0, 0}, {1, 1}};
    CHECK(overlap(box, {{1, 1}, {2, 2}}));
    CHECK(overlap(box, {{0.2, -5}, {0.3, 5}}));
    CHECK_FALSE(overlap(box, {{1.0000001, 0}, {2, 1}}));
    CHECK_FALSE(overlap(box, {{0, -2}, {1, -1e-9}}));
    CHECK(contains(box, box));
    CHECK(contains(box, {{0.1, 0.1}, {0.9, 1}}));
    CHECK_FALSE(contains(box, {{0.1, 0.1}, {0.9, 1.1}}));
    const Aabb both = merge(box, {{-1, 0.5}, {0, 3}});
    CHECK(both.lower == Vec2(-1, 0));
    CHECK(both.upper == Vec2(1, 3));
    const Aabb wider = inflate(box, 0.5);
    CHECK(wider.lower == Vec2(-0.5, -0.5));
    CHECK(wider.upper == Vec2(1.5, 1.5));
}
