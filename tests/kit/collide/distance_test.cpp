// SPDX-License-Identifier: MIT
#include <plumb/collide/distance.h>
#include <algorithm>

#include <limits>
#include <sstream>

#include "cases.h"
#include "catch.h"
#include "kit/collide/placed_pair.h"

namespace {

using minkowski::Outline;
using minkowski::Point;
using namespace plumb;
using namespace plumb::test;

Distance distanceOf(const Placed& p) {
    return distance(p.a, p.poseA, p.b, p.poseB);
}

/// Null when the distance is right.
const char* faultOfDistance(const Placed& p, const Distance& d) {
    const Outline a = outlineOf(p.a, p.poseA), b = outlineOf(p.b, p.poseB);
    const double tolerance = toleranceOf(p), separation = gapBetween(a, b).separation;
    const Point normal = pointOf(d.normal), onA = pointOf(d.pointA), onB = pointOf(d.pointB);
    if (std::fabs(d.separation - separation) > tolerance) return "the separation is not the gap";
    if (std::fabs(length(normal) - 1) > 1e-15) return "the normal is not a unit vector";
    // Where corners nearly touch, the direction is as good as the places are, seen from so near.
    const double coreGap = std::fabs(separation + a.radius + b.radius);
    const double blur = std::min(1.0, tolerance / std::max(coreGap, 1e-300));
    const bool touching = blur > 0.1;
    if (!touching && gapAlong(a, b, normal) < separation - tolerance - blur * p.size)
        return "the normal is not the way that parts them";
    if (length(onB - onA - normal * d.separation) > tolerance) return "the points are not a separation apart";
    if (distanceToBoundary(a.corners, onA - normal * a.radius) > tolerance) return "a point off A's surface";
    if (distanceToBoundary(b.corners, onB + normal * b.radius) > tolerance) return "a point off B's surface";
    if (touching) return nullptr;
    const double left = gapBetween(a, shifted(b, normal * -d.separation)).separation;
    return std::fabs(left) > 2 * tolerance + blur * p.size ? "moved by the separation they do not just touch" : nullptr;
}

const char* faultOfMirrorDistance(const Placed& p, const Distance& d) {
    const Distance mirrored = distance(p.b, p.poseB, p.a, p.poseA);
    if (std::fabs(d.separation - mirrored.separation) > toleranceOf(p)) return "B sees another separation";
    return nullptr;
}

std::string describePlaced(const Placed& p, int index) {
    std::ostringstream text;
    text.precision(17);
    const Distance d = distanceOf(p);
    const Outline a = outlineOf(p.a, p.poseA), b = outlineOf(p.b, p.poseB);
    const minkowski::Gap gap = gapBetween(a, b);
    text << "placement " << index << ", size " << p.size << ", gap " << gap.separation << " along (" << gap.normal.x
         << ", " << gap.normal.y << "); found " << d.separation << " along (" << d.normal.transpose() << ") from ("
         << d.pointA.transpose() << ") to (" << d.pointB.transpose() << ")";
    for (const Outline* outline : {&a, &b}) {
        text << "\n  radius " << outline->radius << " corners";
        for (const Point q : outline->corners) text << " (" << q.x << ", " << q.y << ")";
    }
    return text.str();
}

struct DistanceTally {
    int faults = 0, overlaps = 0;
    double worst = 0;  ///< error of the separation as a part of the size
    std::string first;
};

DistanceTally tallyOfDistances(Kind kindA, Kind kindB) {
    Random random(2000 + 10 * static_cast<std::uint64_t>(kindA) + static_cast<std::uint64_t>(kindB));
    DistanceTally tally;
    for (int i = 0; i < allCases(10'000); ++i) {
        const Placed p = randomPlaced(random, kindA, kindB);
        const Distance d = distanceOf(p);
        const char* fault = faultOfDistance(p, d);
        if (!fault) fault = faultOfMirrorDistance(p, d);
        if (fault && tally.faults++ == 0) tally.first = fault + ("; " + describePlaced(p, i));
        tally.overlaps += d.separation < 0;
        const double gap = gapBetween(outlineOf(p.a, p.poseA), outlineOf(p.b, p.poseB)).separation;
        tally.worst = std::max(tally.worst, std::fabs(d.separation - gap) / p.size);
    }
    return tally;
}

}  // namespace

TEST_CASE("distances of 10,000 placements of each pair of shapes agree with the Minkowski difference", "[collide]") {
    for (const Kind a : kinds) {
        for (const Kind b : kinds) {
            const DistanceTally tally = tallyOfDistances(a, b);
            INFO(nameOf(a) << " and " << nameOf(b) << ": " << tally.overlaps << " overlap, worst error " << tally.worst
                           << " of the size; first fault: " << tally.first);
            CHECK(tally.faults == 0);
            CHECK(tally.overlaps > allCases(1000));
        }
    }
}

TEST_CASE("a fault planted in a distance is found in each of 500 placements", "[collide]") {
    Random random(5);
    int flipped = 0, deeper = 0, shifted = 0, looked = 0;
    while (looked < 500) {
        const Kind a = randomKind(random), b = randomKind(random);
        const Placed p = randomPlaced(random, a, b);
        const Distance d = distanceOf(p);
        if (std::fabs(d.separation) < 1e-9 || d.separation < -0.01 * p.size) continue;  // either way may be right
        ++looked;
        Distance wrong = d;
        wrong.normal = -d.normal;
        std::swap(wrong.pointA, wrong.pointB);
        flipped += faultOfDistance(p, wrong) != nullptr;
        wrong = d;
        wrong.separation -= 1e-13 * p.size;
        deeper += faultOfDistance(p, wrong) != nullptr;
        wrong = d;
        wrong.pointA += 1e-12 * p.size * d.normal;
        wrong.pointB += 1e-12 * p.size * d.normal;
        shifted += faultOfDistance(p, wrong) != nullptr;
    }
    CHECK(flipped == looked);
    CHECK(deeper == looked);
    CHECK(shifted == looked);
}

TEST_CASE("a box 3 m right and 4 m above a box's corner is 5 m away, from corner to corner", "[collide]") {
    const Shape box = boxPolygon({1, 1});
    const Distance d = distance(box, {{0, 0}, {}}, box, {{5, 6}, {}});
    CHECK(d.separation == 5);
    CHECK((d.normal - Vec2(0.6, 0.8)).norm() < 1e-15);
    CHECK(d.pointA == Vec2(1, 1));
    CHECK(d.pointB == Vec2(4, 5));
}

TEST_CASE("a segment has two sides: a circle of 0.5 m at 2 m is 1.5 m away above it and below", "[collide]") {
    const Shape line = Segment{{-3, 0}, {3, 0}};
    for (const double side : {1.0, -1.0}) {
        const Distance d = distance(line, {}, Circle{0.5}, {{1, 2 * side}, {}});
        CHECK(d.separation == 1.5);
        CHECK(d.normal == Vec2(0, side));
        CHECK(d.pointA == Vec2(1, 0));
        CHECK(d.pointB == Vec2(1, 1.5 * side));
    }
}

TEST_CASE("segments in line do not touch across a gap of 0.25 m, and do once they share a point", "[collide]") {
    const Shape unit = Segment{{0, 0}, {1, 0}};
    const Distance apart = distance(unit, {}, unit, {{1.25, 0}, {}});
    CHECK(apart.separation == 0.25);
    CHECK(apart.normal == Vec2(1, 0));
    CHECK(distance(unit, {}, unit, {{0.75, 0}, {}}).separation == 0);
}

TEST_CASE("a chain is as far away as the nearest of its segments, at 1,000 placements of each shape", "[collide]") {
    Random random(17);
    double worst = 0;
    for (const Kind kind : kinds) {
        for (int i = 0; i < 1000; ++i) {
            Chain chain;
            for (int k = 0; k < 5; ++k) chain.points.push_back(randomVec2(random, 3));
            chain.closed = random.integer(0, 1) == 0;
            const Transform poseA{randomVec2(random, 3), turnBy(random.uniform(-3, 3))};
            const Transform poseB{randomVec2(random, 3), turnBy(random.uniform(-3, 3))};
            const Shape other = randomShape(random, kind, 1);
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k + (chain.closed ? 0 : 1) < 5; ++k) {
                const Segment piece{chain.points[k], chain.points[(k + 1) % 5]};
                const minkowski::Gap gap = gapBetween(outlineOf(piece, poseA), outlineOf(other, poseB));
                nearest = std::min(nearest, gap.separation);
            }
            worst = std::max(worst, std::fabs(distance(chain, poseA, other, poseB).separation - nearest));
            worst = std::max(worst, std::fabs(distance(other, poseB, chain, poseA).separation - nearest));
        }
    }
    CHECK(worst < 10 * std::numeric_limits<double>::epsilon() / 2 * 20);  // ten roundings of numbers up to 20
}

TEST_CASE("circles at one place are apart by minus their radii, and the normal is up", "[collide]") {
    const Distance d = distance(Circle{0.5}, {{3, 4}, {}}, Circle{0.25}, {{3, 4}, {}});
    CHECK(d.separation == -0.75);
    CHECK(d.normal == Vec2(0, 1));
}

TEST_CASE("a gap of 1/1024 m between boxes is the same 1,000,000 m from the origin", "[collide]") {
    const Shape box = boxPolygon({0.5, 0.5});
    const Transform a{{1e6, -1e6}, turnBy(0.3)};
    const Vec2 up = a.rotation * Vec2(0, 1 + 1.0 / 1024);
    const Transform b{a.position + up, a.rotation};
    // The place itself is a multiple of 2^-33 there, in x and in y; nothing else may be added, beyond a box's
    // roundings.
    CHECK(std::fabs(distance(box, a, box, b).separation - 1.0 / 1024) < 2 * 0x1p-34 + 1e-15);
}

TEST_CASE("moved or turned by a hair, shapes are as much nearer or farther at most, through contact", "[collide]") {
    // The gap is 1-Lipschitz in the shift, and in the angle times the farthest corner. A search for the time of impact
    // rests on it. 1,000 steps of 1e-3 to 1e-9 of the size along each of 180 ways.
    Random random(11);
    double worst = 0;
    for (int way = 0; way < 180; ++way) {
        Placed p = randomPlaced(random, kinds[static_cast<std::size_t>(way % 6)],
                                kinds[static_cast<std::size_t>(way / 6 % 6)]);
        const double step = p.size * std::pow(10, random.uniform(-9, -3));
        const double angle = random.uniform(0, 2 * std::numbers::pi), turn = random.uniform(-1, 1) * step / p.size;
        const double reach = step + std::fabs(turn) * largestNumber(p.b);
        double before = distanceOf(p).separation;
        for (int i = 0; i < 1000; ++i) {
            p.poseB.position += step * Vec2(std::cos(angle), std::sin(angle));
            p.poseB.rotation = turnBy(turn) * p.poseB.rotation;
            const double now = distanceOf(p).separation;
            worst = std::max(worst, (std::fabs(now - before) - reach) / toleranceOf(p));
            before = now;
        }
    }
    CAPTURE(worst);
    CHECK(worst < 1);
}
