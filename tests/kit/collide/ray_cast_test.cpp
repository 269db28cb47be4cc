// SPDX-License-Identifier: MIT
#include <plumb/collide/ray_cast.h>

#include <sstream>

#include "cases.h"
#include "catch.h"
#include "kit/collide/casts.h"
#include "kit/collide/placements.h"

namespace {

using casts::Case;
using minkowski::Outline;
using minkowski::Point;
using namespace plumb;
using namespace plumb::test;

struct Ray {
    Vec2 from, to;
};

Vec2 pick(Random& random, const Outline& outline) {
    const Point p = placements::cornerOf(random, outline);
    return {p.x, p.y};
}

/// From inside, along edges, through corners, from far away, of no length, and any other.
Ray randomRay(Random& random, const Outline& outline, double scale) {
    const Vec2 corner = pick(random, outline), other = pick(random, outline);
    const Vec2 near = corner + randomVec2(random, 2 * outline.radius + 0.5 * scale), aside = randomVec2(random, scale);
    switch (random.integer(0, 6)) {
        case 0: return {0.5 * (corner + other), near + aside};
        case 1: return {corner + (corner - other) * random.uniform(-1, 3), other + (other - corner)};
        case 2: return {corner + 3 * aside, corner - random.uniform(-0.5, 2) * aside};
        case 3: return {near + 1e4 * aside, near - 1e4 * aside};
        case 4: return {near, near};
        case 5: return {near, near + 1e-9 * aside};
        default: return {near + 2 * aside, near - random.uniform(-1, 2) * aside + randomVec2(random, scale)};
    }
}

struct RayTally {
    int faults = 0, hits = 0, inside = 0;
    std::string first;
};

Case rayCase(const Shape& shape, const Transform& pose, const Ray& ray) {
    Case c{outlineOf(shape, pose), {{pointOf(ray.from)}, 0}, pointOf(ray.to - ray.from)};
    const Vec2 reach = ray.from.cwiseAbs() + ray.to.cwiseAbs() + pose.position.cwiseAbs();
    c.size = largestNumber(shape) + reach.maxCoeff();
    return c;
}

std::string describeRay(const Case& c, const Ray& ray, int index) {
    std::ostringstream text;
    text.precision(17);
    text << "ray " << index << " from (" << ray.from.transpose() << ") to (" << ray.to.transpose() << "), gap "
         << gapAt(c, 0) << ", least " << leastGap(c) << ", radius " << c.target.radius << " corners";
    for (const Point q : c.target.corners) text << " (" << q.x << ", " << q.y << ")";
    return text.str();
}

RayTally tallyOfRays(Kind kind) {
    Random random(3000 + static_cast<std::uint64_t>(kind));
    RayTally tally;
    for (int i = 0; i < allCases(20'000); ++i) {
        const double scale = 0.05 * std::pow(100, random.uniform(0, 1));
        const Shape shape = randomShape(random, kind, scale);
        const bool square = random.integer(0, 3) == 0;
        const Transform pose{randomVec2(random, scale), turnBy(square ? 0 : random.uniform(-3, 3))};
        const Ray ray = randomRay(random, outlineOf(shape, pose), scale);
        const Case c = rayCase(shape, pose, ray);
        const std::optional<CastPoint> hit = castRay(ray.from, ray.to, shape, pose);
        const char* fault = faultOf(c, hit);
        if (fault && tally.faults++ == 0) tally.first = fault + ("; " + describeRay(c, ray, i));
        tally.hits += hit.has_value();
        tally.inside += hit && hit->fraction == 0;
    }
    return tally;
}

}  // namespace

TEST_CASE("where 20,000 rays meet each shape is where the distance to it comes to nothing", "[collide]") {
    for (const Kind kind : kinds) {
        const RayTally tally = tallyOfRays(kind);
        INFO(nameOf(kind) << ": " << tally.hits << " hits, " << tally.inside << " from inside; " << tally.faults
                          << " faults, the first: " << tally.first);
        CHECK(tally.faults == 0);
        CHECK(tally.hits > allCases(2000));
        CHECK(tally.inside > allCases(10));
    }
}

TEST_CASE("a fault planted in a ray's hit is found in each of 500", "[collide]") {
    Random random(9);
    int looked = 0, nearer = 0, farther = 0, turned = 0, none = 0;
    while (looked < 500) {
        const Shape shape = randomShape(random, randomKind(random), 1);
        const Transform pose{randomVec2(random, 1), turnBy(random.uniform(-3, 3))};
        const Ray ray = randomRay(random, outlineOf(shape, pose), 1);
        const std::optional<CastPoint> hit = castRay(ray.from, ray.to, shape, pose);
        const Case c = rayCase(shape, pose, ray);
        if (!hit || hit->fraction == 0 || c.size > 100 || leastGap(c) > -1e-3) continue;
        if (-hit->normal.dot(ray.to - ray.from) < 0.1) continue;
        ++looked;
        CastPoint wrong = *hit;
        wrong.fraction -= 1e-11;
        nearer += casts::faultOf(c, wrong) != nullptr;
        wrong.fraction += 2e-11;
        farther += casts::faultOf(c, wrong) != nullptr;
        wrong = *hit;
        wrong.normal = -wrong.normal;
        turned += casts::faultOf(c, wrong) != nullptr;
        none += casts::faultOf(c, std::nullopt) != nullptr;
    }
    CHECK(nearer == looked);
    CHECK(farther == looked);
    CHECK(turned == looked);
    CHECK(none == looked);
}

TEST_CASE("a ray of 10 m meets a box 4 m on at 0.4 of its way, and a circle 2 m on at 0.2", "[collide]") {
    const std::optional<CastPoint> box = castRay({0, 0}, {10, 0}, boxPolygon({1, 1}), {{5, 0.5}, {}});
    REQUIRE(box);
    CHECK(box->fraction == 0.4);
    CHECK(box->point == Vec2(4, 0));
    CHECK(box->normal == Vec2(-1, 0));
    const std::optional<CastPoint> circle = castRay({0, 0}, {10, 0}, Circle{0.5}, {{2.5, 0}, {}});
    REQUIRE(circle);
    CHECK(circle->fraction == 0.2);
    CHECK(circle->normal == Vec2(-1, 0));
}

TEST_CASE("a ray that ends 0.001 m before a wall misses it, and one that ends on it meets it", "[collide]") {
    const Shape wall = boxPolygon({1, 1});
    CHECK_FALSE(castRay({0, 0}, {3.999, 0}, wall, {{5, 0}, {}}));
    const std::optional<CastPoint> hit = castRay({0, 0}, {4, 0}, wall, {{5, 0}, {}});
    REQUIRE(hit);
    CHECK(hit->fraction == 1);
}

TEST_CASE("a ray from inside meets at 0, its normal against it, one that begins on an edge does too", "[collide]") {
    const Shape box = boxPolygon({1, 1});
    for (const Vec2& from : {Vec2(0.5, 0), Vec2(-1, 0), Vec2(1, 0)}) {
        const std::optional<CastPoint> hit = castRay(from, from + Vec2(3, 4), box, {});
        REQUIRE(hit);
        CHECK(hit->fraction == 0);
        CHECK(hit->point == from);
        CHECK((hit->normal + Vec2(0.6, 0.8)).norm() < 1e-15);
    }
    const std::optional<CastPoint> none = castRay({0.5, 0.25}, {0.5, 0.25}, box, {});
    REQUIRE(none);
    CHECK(none->normal == Vec2(1, 0));
}

TEST_CASE("a line is met from either side, along itself at its end, and not beyond its ends", "[collide]") {
    const Shape line = Segment{{-1, 0}, {1, 0}};
    CHECK(castRay({0, 2}, {0, -2}, line, {})->normal == Vec2(0, 1));
    CHECK(castRay({0, -2}, {0, 2}, line, {})->normal == Vec2(0, -1));
    const std::optional<CastPoint> along = castRay({-3, 0}, {3, 0}, line, {});
    REQUIRE(along);
    CHECK(along->point == Vec2(-1, 0));
    CHECK(along->normal == Vec2(-1, 0));
    CHECK_FALSE(castRay({-3, 0}, {-1.5, 0}, line, {}));
    CHECK_FALSE(castRay({1.5, 2}, {1.5, -2}, line, {}));
    CHECK(castRay({1, 2}, {1, -2}, line, {})->fraction == 0.5);
}

TEST_CASE("no ray of 100,000 slips through a joint of a closed chain at which it is aimed", "[collide]") {
    Random random(21);
    int slipped = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double height = random.uniform(0.1, 2), bend = random.uniform(-0.9, 0.9);
        const Chain chain{{{-3, height}, {bend, height + bend}, {3, height}, {0, -5}}, true};
        const Transform pose{randomVec2(random, 1e3), turnBy(random.uniform(-3, 3))};
        const Vec2 joint = pose * chain.points[1], from = pose * Vec2(bend, -0.5 + 0.2 * bend);
        slipped += !castRay(from, from + 2 * (joint - from), chain, pose);
    }
    CHECK(slipped == 0);
}

TEST_CASE("a chain is met where the first of its segments is, by 20,000 rays", "[collide]") {
    Random random(23);
    int faults = 0, hits = 0;
    for (int i = 0; i < allCases(20'000); ++i) {
        Chain chain;
        for (int k = 0; k < 5; ++k) chain.points.push_back(randomVec2(random, 3));
        chain.closed = random.integer(0, 1) == 0;
        const Transform pose{randomVec2(random, 3), turnBy(random.uniform(-3, 3))};
        const Ray ray{randomVec2(random, 9), randomVec2(random, 9)};
        const std::optional<CastPoint> hit = castRay(ray.from, ray.to, chain, pose);
        hits += hit.has_value();
        int met = 0;
        const char* fault = nullptr;
        for (std::size_t k = 0; k + (chain.closed ? 0 : 1) < 5; ++k) {
            Case c = rayCase(Segment{chain.points[k], chain.points[(k + 1) % 5]}, pose, ray);
            if (hit) met += casts::faultOf(c, hit) == nullptr;
            // Up to there, no other segment is met.
            if (hit) c.shift = c.shift * (hit->fraction - 1e-9);
            if (leastGap(c) < -toleranceOf(c)) fault = "met before";
        }
        faults += fault != nullptr || (hit && met == 0);
    }
    CHECK(faults == 0);
    CHECK(hits > allCases(4000));
}
