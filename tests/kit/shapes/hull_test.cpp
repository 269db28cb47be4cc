// SPDX-License-Identifier: MIT
#include <plumb/shapes/hull.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <plumb/math/random.h>

#include "catch.h"

using namespace plumb;

namespace {

bool less(const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Of points with small whole coordinates, so that products are exact: the ends of every line between two that has none
/// on its right, and none in line beyond its ends.
std::vector<Vec2> bruteHull(const std::vector<Vec2>& points) {
    std::vector<Vec2> corners;
    const auto isEdge = [&](const Vec2& from, const Vec2& to) {
        const Vec2 edge = to - from;
        return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
            const Vec2 fromStart = p - from;
            const double turn = cross(edge, fromStart), along = edge.dot(fromStart);
            return turn > 0 || (turn == 0 && along >= 0 && along <= edge.squaredNorm());
        });
    };
    for (const Vec2& from : points)
        for (const Vec2& to : points)
            if (from != to && isEdge(from, to)) corners.insert(corners.end(), {from, to});
    std::sort(corners.begin(), corners.end(), less);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

Vec2 onCircle(double angle, double radius) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

double extentOf(const std::vector<Vec2>& points) {
    double extent = 0;
    for (const Vec2& p : points) extent = std::max(extent, (p - points.front()).norm());
    return extent;
}

double outsideOfPolygon(const Polygon& polygon, const Vec2& point) {
    double outside = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec2 from = polygon.vertices[i];
        const Vec2 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - from, away = point - from;
        outside = std::max(outside, -cross(edge, away) / edge.norm());
    }
    return outside;
}

/// Points that hulls stumble over: on a polygon's edges and corners, off by a hair, some twice.
std::vector<Vec2> stumblingBlocks(Random& random) {
    const int corners = random.integer(3, 12), count = random.integer(3, 60);
    const double size = std::pow(10, random.uniform(-6, 6)), off = std::pow(10, random.uniform(-17, -3)) * size;
    const Vec2 shift = random.integer(0, 1) == 0 ? Vec2(0, 0) : onCircle(random.uniform(0, 6), 100 * size);
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const int corner = random.integer(0, corners - 1);
        const double part = random.integer(0, 1) == 0 ? 0 : random.uniform(0, 1);
        const Vec2 from = onCircle(2 * std::numbers::pi * corner / corners, size);
        const Vec2 to = onCircle(2 * std::numbers::pi * (corner + 1) / corners, size);
        const double x = random.uniform(-off, off);
        const double y = random.uniform(-off, off);
        points.emplace_back(shift + from + part * (to - from) + Vec2(x, y));
        if (random.integer(0, 3) == 0) points.push_back(points.front());
    }
    return points;
}

}  // namespace

TEST_CASE("hulls of 10,000 clouds of points are what brute force finds", "[shapes][hull]") {
    Random random(51);
    int made = 0, refused = 0, faults = 0;
    for (int round = 0; round < 10'000; ++round) {
        const int count = random.integer(1, 25), reach = random.integer(1, 12);
        std::vector<Vec2> points;
        for (int i = 0; i < count; ++i) {
            const int x = random.integer(-reach, reach);
            const int y = random.integer(-reach, reach);
            points.emplace_back(x, y);
        }
        std::vector<Vec2> expected = bruteHull(points);
        try {
            std::vector<Vec2> corners = hullOf(points).vertices;
            ++made;
            faults += corners.front() != *std::min_element(corners.begin(), corners.end(), less);
            validate(Polygon{corners}, "hull");  // in order, and counter-clockwise
            std::sort(corners.begin(), corners.end(), less);
            faults += corners != expected;
        } catch (const std::invalid_argument&) {
            ++refused;
            faults += expected.size() > 2;
        }
    }
    CHECK(faults == 0);
    CHECK(made > 7000);
    CHECK(refused > 500);
}

TEST_CASE("what hullOf returns is a polygon that a body can have, and nothing sticks out by more than 5e-6 of it",
          "[shapes][hull]") {
    // A corner is left out that turns by 1.5e-6, or has an edge of 1.5e-6 of the whole before it: each time one goes,
    // the outline retreats by less than that; a few go one after the other.
    Random random(53);
    int made = 0;
    double worst = 0;
    for (int round = 0; round < 10'000; ++round) {
        const std::vector<Vec2> points = stumblingBlocks(random);
        Polygon hull;
        try {
            hull = hullOf(points);
        } catch (const std::invalid_argument&) {
            continue;
        }
        ++made;
        REQUIRE_NOTHROW(validate(hull, "hull"));
        for (const Vec2& p : points) worst = std::max(worst, outsideOfPolygon(hull, p) / extentOf(points));
    }
    CHECK(made > 8000);
    CHECK(worst < 5e-6);
}

TEST_CASE("a hull has at most 64 corners and at least 3", "[shapes][hull][errors]") {
    const auto evenly = [](int count) {
        std::vector<Vec2> points;
        for (int i = 0; i < count; ++i) points.push_back(onCircle(2 * std::numbers::pi * i / count, 1));
        return points;
    };
    CHECK(hullOf(evenly(64)).vertices.size() == 64);
    CHECK_THROWS_AS(hullOf(evenly(65)), std::invalid_argument);
    CHECK_THROWS_WITH(hullOf(evenly(65)), "hullOf.points: 65 corners, made of 65 points, are more than 64");
    CHECK_THROWS_WITH(hullOf({}), "hullOf.points: 0 corners, made of 0 points, are fewer than 3");
    const std::vector<Vec2> line{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
    CHECK_THROWS_AS(hullOf(line), std::invalid_argument);
    const std::vector<Vec2> same(9, Vec2(4, 5));
    CHECK_THROWS_AS(hullOf(same), std::invalid_argument);
    const std::vector<Vec2> bad{{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {0, 1}};
    CHECK_THROWS_WITH(hullOf(bad), "hullOf.points[1]: (1, nan) is not finite");
}

TEST_CASE("hulls do not mind how large or small lengths are", "[shapes][hull]") {
    for (const double size : {1e-300, 1e-30, 1.0, 1e30, 1e300}) {
        const std::vector<Vec2> points{{0, 0}, {size, 0}, {0.25 * size, 0.25 * size}, {0, size}};
        CHECK(hullOf(points).vertices.size() == 3);
    }
}
