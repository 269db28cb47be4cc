// SPDX-License-Identifier: MIT
#include <plumb/collide/shape_cast.h>
#include <algorithm>

#include <sstream>

#include "cases.h"
#include "catch.h"
#include "kit/collide/casts.h"
#include "kit/collide/placements.h"

namespace {

using casts::Case;
using namespace plumb;
using namespace plumb::test;

struct Shifted {
    Shape moving, target;
    Transform pose, targetPose;
    Vec2 shift{0, 0};
};

/// Towards each other, apart, past each other, flush, and from every relation that placements know.
Shifted randomShifted(Random& random, Kind kindMoving, Kind kindTarget) {
    const double scale = 0.05 * std::pow(100, random.uniform(0, 1));
    Shifted s;
    s.moving = randomShape(random, kindMoving, scale * random.uniform(0.3, 3));
    s.target = randomShape(random, kindTarget, scale);
    const Regime regime = static_cast<Regime>(random.integer(0, regimes - 1));
    s.targetPose = {randomVec2(random, scale), turnBy(random.uniform(-3, 3))};
    const minkowski::Outline target = outlineOf(s.target, {{0, 0}, s.targetPose.rotation});
    double angle = random.uniform(-3, 3);
    if (regime == Regime::Flush) angle = placements::flushAngle(random, target, outlineOf(s.moving, {}));
    s.pose.rotation = turnBy(angle);
    const minkowski::Point there = placements::place(random, regime, target, outlineOf(s.moving, s.pose), scale);
    const Vec2 met = s.targetPose.position + Vec2(there.x, there.y);
    const double far = random.integer(0, 9) == 0 ? 1e3 : random.uniform(0, 3);
    const Vec2 back = randomVec2(random, scale) * far;
    const double on = random.uniform(-0.5, 1.5);
    s.pose.position = met - back;
    s.shift = random.integer(0, 19) == 0 ? Vec2(0, 0) : Vec2(back * (1 + on));
    return s;
}

Case castCase(const Shifted& s) {
    Case c{outlineOf(s.target, s.targetPose), outlineOf(s.moving, s.pose), pointOf(s.shift)};
    const Vec2 reach = s.pose.position.cwiseAbs() + s.targetPose.position.cwiseAbs() + s.shift.cwiseAbs();
    c.size = largestNumber(s.moving) + largestNumber(s.target) + reach.maxCoeff();
    return c;
}

std::optional<CastPoint> castOf(const Shifted& s) {
    return castShape(s.moving, s.pose, s.shift, s.target, s.targetPose);
}

std::string describeCast(const Case& c, const std::optional<CastPoint>& hit, int index) {
    std::ostringstream text;
    text.precision(17);
    text << "cast " << index << " by (" << c.shift.x << ", " << c.shift.y << "), size " << c.size << ", gap "
         << gapAt(c, 0) << ", least " << leastGap(c);
    if (hit)
        text << "; found " << hit->fraction << ", normal (" << hit->normal.transpose() << "), gap there "
             << gapAt(c, hit->fraction);
    for (const minkowski::Outline* outline : {&c.target, &c.moving}) {
        text << "\n  radius " << outline->radius << " corners";
        for (const minkowski::Point q : outline->corners) text << " (" << q.x << ", " << q.y << ")";
    }
    return text.str();
}

struct CastTally {
    int faults = 0, hits = 0, atStart = 0;
    std::string first;
};

CastTally tallyOfCasts(Kind moving, Kind target, int casts) {
    Random random(4000 + 10 * static_cast<std::uint64_t>(moving) + static_cast<std::uint64_t>(target));
    CastTally tally;
    for (int i = 0; i < casts; ++i) {
        const Shifted s = randomShifted(random, moving, target);
        const std::optional<CastPoint> hit = castOf(s);
        const Case c = castCase(s);
        const char* fault = faultOf(c, hit);
        if (fault && tally.faults++ == 0) tally.first = fault + ("; " + describeCast(c, hit, i));
        tally.hits += hit.has_value();
        tally.atStart += hit && hit->fraction == 0;
    }
    return tally;
}

}  // namespace

TEST_CASE("where 2,000 shifted shapes of each two kinds meet is where the Minkowski difference says", "[collide]") {
    for (const Kind moving : kinds) {
        for (const Kind target : kinds) {
            const CastTally tally = tallyOfCasts(moving, target, allCases(2000));
            INFO(nameOf(moving) << " to " << nameOf(target) << ": " << tally.hits << " hits, " << tally.atStart
                                << " at the start; " << tally.faults << " faults, the first: " << tally.first);
            CHECK(tally.faults == 0);
            CHECK(tally.hits > allCases(500));
            CHECK(tally.atStart > allCases(20));
        }
    }
}

TEST_CASE("a box of 1 m shifted 10 m to a wall 4 m off stops at 0.4, flat on it", "[collide]") {
    const Shape box = boxPolygon({0.5, 0.5}), wall = boxPolygon({0.5, 3});
    const std::optional<CastPoint> hit = castShape(box, {{0, 0}, {}}, {10, 0}, wall, {{5, 0}, {}});
    REQUIRE(hit);
    CHECK(hit->fraction == 0.4);
    CHECK(hit->normal == Vec2(-1, 0));
    CHECK(hit->point.x() == 4.5);
    CHECK(std::fabs(hit->point.y()) <= 0.5);
    CHECK_FALSE(castShape(box, {{0, 0}, {}}, {3.999, 0}, wall, {{5, 0}, {}}));
    CHECK_FALSE(castShape(box, {{0, 0}, {}}, {-10, 0}, wall, {{5, 0}, {}}));
}

TEST_CASE("a corner that comes straight at a corner is met along the way", "[collide]") {
    const Shape box = boxPolygon({1, 1});
    const std::optional<CastPoint> hit = castShape(box, {{-4, -4}, {}}, {4, 4}, box, {});
    REQUIRE(hit);
    CHECK(std::fabs(hit->fraction - 0.5) < 1e-15);
    CHECK((hit->point - Vec2(-1, -1)).norm() < 1e-15);
    CHECK(hit->normal.dot(Vec2(1, 1)) < -0.99);
}

TEST_CASE("a disc of 0.5 m that passes a disc of 0.5 m meets it at 0.999999 m and not at 1.000001 m", "[collide]") {
    const Shape disc = Circle{0.5};
    CHECK(castShape(disc, {{-5, 0.999999}, {}}, {10, 0}, disc, {}));
    CHECK_FALSE(castShape(disc, {{-5, 1.000001}, {}}, {10, 0}, disc, {}));
}

TEST_CASE("a cast shape without size is a ray, to the last places, 20,000 times", "[collide]") {
    Random random(31);
    double worst = 0;
    int differ = 0, hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Shape shape = randomShape(random, randomKind(random), 1);
        const Transform pose{randomVec2(random, 1), turnBy(random.uniform(-3, 3))};
        const Vec2 from = randomVec2(random, 4), to = randomVec2(random, 4);
        const std::optional<CastPoint> ray = castRay(from, to, shape, pose);
        const std::optional<CastPoint> cast = castShape(Circle{0}, {from, {}}, to - from, shape, pose);
        differ += ray.has_value() != cast.has_value();
        if (!ray || !cast) continue;
        ++hits;
        const double closing = -ray->normal.dot(to - from);
        worst = std::max(worst, std::fabs(ray->fraction - cast->fraction) * closing);
    }
    CHECK(differ == 0);
    CHECK(worst < 30 * std::numeric_limits<double>::epsilon() / 2 * 12);  // of numbers up to 12
    CHECK(hits > 2000);
}

TEST_CASE("a chain meets, and is met, where the first of its segments is, 4,000 times", "[collide]") {
    Random random(37);
    int differ = 0, hits = 0;
    for (int i = 0; i < 4000; ++i) {
        Chain chain;
        for (int k = 0; k < 4; ++k) chain.points.push_back(randomVec2(random, 2));
        const Transform chainPose{randomVec2(random, 2), turnBy(random.uniform(-3, 3))};
        const Shape other = randomShape(random, randomKind(random), 1);
        const Transform pose{randomVec2(random, 6), turnBy(random.uniform(-3, 3))};
        const Vec2 shift = randomVec2(random, 9);
        const bool moves = random.integer(0, 1) == 0;
        const auto castOf = [&](const Shape& line) {
            return moves ? castShape(line, chainPose, shift, other, pose)
                         : castShape(other, pose, shift, line, chainPose);
        };
        double first = 2;
        for (std::size_t k = 0; k < 3; ++k)
            if (const std::optional<CastPoint> hit = castOf(Segment{chain.points[k], chain.points[k + 1]}))
                first = std::min(first, hit->fraction);
        const std::optional<CastPoint> hit = castOf(chain);
        differ += hit ? hit->fraction != first : first != 2;
        hits += hit.has_value();
    }
    CHECK(differ == 0);
    CHECK(hits > 500);
}
