// SPDX-License-Identifier: MIT
#include <plumb/collide/convex.h>

#include <cmath>
#include <stdexcept>

#include "catch.h"

using namespace plumb;

TEST_CASE("a circle of 0.5 m at (3, 4) is one point with that radius, seen from (1, 1)", "[collide]") {
    const Convex circle = convexOf(Circle{0.5, {3, 4}}, {1, 1});
    CHECK(circle.count == 1);
    CHECK(circle.radius == 0.5f);
    CHECK(circle.vertices[0] == Vec2f(2, 3));
}

TEST_CASE("a segment is two points with opposite normals, the first on its right", "[collide]") {
    const Convex segment = convexOf(Segment{{0, 0}, {3, 4}}, {0, 0});
    CHECK(segment.count == 2);
    CHECK(segment.radius == 0);
    CHECK(segment.vertices[1] == Vec2f(3, 4));
    CHECK((segment.normals[0] - Vec2f(0.8f, -0.6f)).norm() < 1e-7f);
    CHECK(segment.normals[1] == -segment.normals[0]);
}

TEST_CASE("a box has four corners and a normal out of each edge", "[collide]") {
    const Convex box = convexOf(boxPolygon({2, 1}), {0, 0});
    REQUIRE(box.count == 4);
    CHECK(box.radius == 0);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2f middle = (box.vertices[i] + box.vertices[(i + 1) % 4]) / 2;
        const Vec2f outward = middle.normalized();
        CHECK(box.normals[i] == outward);
    }
}

TEST_CASE("seen from a centre 1,000,000 m out, a polygon beside it keeps its corners to the last bit", "[collide]") {
    const Vec2 far(1e6, -1e6);
    Polygon triangle{{{0, 0}, {0.375, 0.125}, {0.25, 0.5}}};
    const Convex near = convexOf(triangle, {0, 0});
    for (Vec2& corner : triangle.vertices) corner += far;
    const Convex moved = convexOf(triangle, far);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(moved.vertices[i] == near.vertices[i]);
        CHECK(moved.normals[i] == near.normals[i]);
    }
}

TEST_CASE("a 0.1 mm edge 100 m from the centre has its normal right to 1e-7", "[collide]") {
    // Its corners are rounded to 4e-6 m there, a tenth of a radian of its length: so the normal must not come from
    // them.
    Polygon sliver{{{100, 0}, {100 + 0.6e-4, 0.8e-4}, {99, 1}}};
    const Convex convex = convexOf(sliver, {0, 0});
    // 100 + 0.6e-4 itself is off by 1.4e-14 in double: 1.4e-10 of the edge.
    CHECK((convex.normals[0] - Vec2f(0.8f, -0.6f)).norm() < 1e-7f);
}

TEST_CASE("a capsule is two points with its radius, a rounded polygon its corners with its", "[collide]") {
    const Convex capsule = convexOf(Capsule{{0, 0}, {3, 4}, 0.25}, {1, 1});
    CHECK(capsule.count == 2);
    CHECK(capsule.radius == 0.25f);
    CHECK(capsule.vertices[1] == Vec2f(2, 3));
    CHECK((capsule.normals[0] - Vec2f(0.8f, -0.6f)).norm() < 1e-7f);
    Polygon box = boxPolygon({2, 1});
    box.radius = 0.5;
    const Convex rounded = convexOf(box, {0, 0});
    CHECK(rounded.count == 4);
    CHECK(rounded.radius == 0.5f);
    CHECK(rounded.vertices[2] == Vec2f(2, 1));
}

TEST_CASE("a polygon of 64 corners has them all, and keeps them when it is copied", "[collide]") {
    Polygon round;
    for (int i = 0; i < 64; ++i) round.vertices.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i));
    Convex convex;
    {
        const Convex original = convexOf(round, {0, 0});
        convex = original;
    }
    REQUIRE(convex.count == 64);
    for (std::size_t i = 0; i < 64; ++i) CHECK(convex.vertices[i] == round.vertices[i].cast<float>());
}

TEST_CASE("a piece of a chain knows its neighbours' normals, on the side of its own first one", "[collide]") {
    // Rightwards, then up: the first normal of each piece is on its right.
    Segment segment{{0, 0}, {1, 0}};
    segment.before = Vec2(-1, 1);
    segment.after = Vec2(1, 3);
    const Convex piece = convexOf(segment, {0, 0});
    CHECK(piece.normals[0] == Vec2f(0, -1));
    CHECK((piece.before - Vec2f(-std::sqrt(0.5f), -std::sqrt(0.5f))).norm() < 1e-7f);
    CHECK(piece.after == Vec2f(1, 0));
    const Convex alone = convexOf(Segment{{0, 0}, {1, 0}}, {0, 0});
    CHECK(alone.before == Vec2f(0, 0));
    CHECK(alone.after == Vec2f(0, 0));
    CHECK_THROWS_AS(convexOf(Chain{{{0, 0}, {1, 0}}}, {0, 0}), std::invalid_argument);
}

TEST_CASE("a box takes no more than 150 bytes, and no memory of its own", "[collide]") {
    static_assert(sizeof(Convex) <= 150);
    const Convex box = convexOf(boxPolygon({1, 1}), {0, 0});
    const auto* inside = reinterpret_cast<const unsigned char*>(box.vertices.x());
    const auto* start = reinterpret_cast<const unsigned char*>(&box);
    CHECK((inside >= start && inside < start + sizeof(Convex)));
}
