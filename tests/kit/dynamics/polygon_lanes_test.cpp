// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/random.h>

#include "catch.h"
#include "lanes_compare.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// Sixteen pairs of polygons, capsules and segments, apart, overlapping, or edge to edge.
struct PolygonPairs {
    std::vector<BodyMotion> motion{1};
    std::vector<BodyPlace> place{1};
    ContactStore store;
    PairLanes pairs{};
    std::vector<Convex> shapes;
    double size[batchLanes];

    CornerTable corners() const { return {store.corners.data(), store.moreCorners.data()}; }
};

Polygon regular(int corners, double radius, double turn) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / corners;
        polygon.vertices.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

Shape polygonShape(Random& random, double scale, int mostCorners) {
    const double rounding = random.integer(0, 2) == 0 ? scale * random.uniform(0.01, 0.3) : 0;
    const Vec2 end = scale * Vec2(random.uniform(0.3, 1), random.uniform(-1, 1));
    const int kind = random.integer(0, 5);
    if (kind == 0) return Capsule{.start = -end, .end = end, .radius = scale * random.uniform(0.1, 0.5)};
    if (kind == 1) return Segment{.start = -end, .end = end};
    if (kind == 2) {
        Polygon box = boxPolygon(scale * Vec2(random.uniform(0.2, 1), random.uniform(0.2, 1)));
        box.radius = rounding;
        return box;
    }
    Polygon polygon = regular(random.integer(3, mostCorners), scale * random.uniform(0.4, 1), random.uniform(0, 6));
    if (kind == 3)  // stretched: no two edges are alike
        for (Vec2& corner : polygon.vertices) corner.x() *= 0.4;
    polygon.radius = rounding;
    return polygon;
}

/// Two edges of two polygons face each other, to a rounding, as in a heap at rest; seen from A's frame.
Transform flushPose(const Convex& a, const Convex& b, Random& random) {
    const auto i = static_cast<std::size_t>(random.integer(0, a.count - 1)),
               j = static_cast<std::size_t>(random.integer(0, b.count - 1));
    const Vec2 na = a.normals[i].cast<double>(), nb = b.normals[j].cast<double>();
    const Rot turn = Rot::fromAngle(std::atan2(-na.y(), -na.x()) - std::atan2(nb.y(), nb.x()));
    const double gap = static_cast<double>(a.radius + b.radius) + random.uniform(-0.005, 0.005);
    const Vec2 corner = a.vertices[i].cast<double>() + na * gap;
    const Vec2 along = perp(na) * random.uniform(-0.2, 0.2);
    const std::size_t end = (j + 1) % static_cast<std::size_t>(b.count);
    return {corner + along - turn * Vec2(b.vertices[end].cast<double>()), turn};
}

PolygonPairs randomPolygons(Random& random) {
    PolygonPairs pairs;
    const int mostCorners = random.integer(0, 1) == 0 ? 4 : 8;
    for (std::uint32_t lane = 0; lane < batchLanes; ++lane) {
        const double scale = std::exp(random.uniform(-2, 2));
        const Shape shapes[] = {polygonShape(random, scale, mostCorners), polygonShape(random, scale, mostCorners)};
        for (std::uint32_t k = 0; k < 2; ++k) {
            pairs.shapes.push_back(convexOf(shapes[k], {0, 0}));
            setOutline(pairs.store, 2 * lane + k, boxOutlineOf({.shape = shapes[k]}, {0, 0}), pairs.shapes.back());
        }
        const Convex &a = pairs.shapes[2 * lane], &b = pairs.shapes[2 * lane + 1];
        const double way = random.uniform(-3, 3);
        Transform pose{scale * random.uniform(0, 2) * Vec2(std::cos(way), std::sin(way)),
                       Rot::fromAngle(random.uniform(-3, 3))};
        if (random.integer(0, 1) == 0) pose = flushPose(a, b, random);
        const double angle = random.uniform(-3, 3);
        const Vec2 at(1000 * random.uniform(-1, 1), 1000 * random.uniform(-1, 1));
        addBody(pairs, at, angle);
        addBody(pairs, at + Rot::fromAngle(angle) * pose.position,
                angle + std::atan2(pose.rotation.sin, pose.rotation.cos));
        ContactRecord contact;
        contact.proxyA = 2 * lane;
        contact.proxyB = 2 * lane + 1;
        contact.bodyA = 2 * lane + 1;
        contact.bodyB = 2 * lane + 2;
        fillPair(pairs.store, contact, pairs.pairs, lane);
        pairs.size[lane] = 4 * scale;
    }
    return pairs;
}

FreshLanes collide(const PolygonPairs& pairs, int lanes) {
    Lanes<std::int32_t> all;
    std::fill(std::begin(all), std::end(all), 1);
    FreshLanes fresh{};
    laneCollider(lanes).collidePolygons(pairs.pairs, pairs.place.data(), pairs.corners(), all, fresh, batchLanes);
    return fresh;
}

}  // namespace

TEST_CASE("polygons side by side have the manifolds that they have one by one, in 20,000 placements",
          "[dynamics][lanes][property]") {
    Random random(15);
    Agreement agreement;
    for (int round = 0; round < 20'000 / batchLanes; ++round) {
        const PolygonPairs pairs = randomPolygons(random);
        const FreshLanes fresh = collide(pairs, 1);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            INFO("round " << round << ", lane " << lane);
            const auto tolerance = static_cast<float>(4e-6 * pairs.size[lane]);
            const Manifold one =
                manifold(pairs.shapes[2 * lane], pairs.shapes[2 * lane + 1],
                         relativePose(pairs.motion[2 * lane + 1], pairs.motion[2 * lane + 2]), contactMargin);
            compare(one, manifoldIn(fresh, lane), {tolerance, 10 * tolerance, 0.9999f}, agreement);
        }
    }
    CHECK(agreement.touching > 10'000);
    // where two edges do equally well, or a point is at the margin or the corner
    CHECK(agreement.otherwise < agreement.touching / 100);
}

TEST_CASE("polygons have the same manifolds to the bit at 1, 4, 8 and 16 lanes", "[dynamics][lanes][property]") {
    Random random(16);
    for (int round = 0; round < 1'000; ++round) {
        const PolygonPairs pairs = randomPolygons(random);
        const FreshLanes first = collide(pairs, 1);
        INFO("round " << round);
        for (const int lanes : {4, 8, 16}) CHECK(sameBits(collide(pairs, lanes), first));
    }
}
