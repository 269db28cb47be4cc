// SPDX-License-Identifier: MIT
#include <plumb/collide/sweep.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include <plumb/collide/shape_cast.h>

#include "cases.h"
#include "catch.h"
#include "kit/collide/fine_stepping.h"
#include "kit/collide/placements.h"

using fine_stepping::Pair;
using fine_stepping::referencePose;
using fine_stepping::Verdict;
using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double touchTolerance = 1e-5;

/// A chain now and then, of 2 to 4 segments, else one of the convex kinds.
Shape anyShape(Random& random, double scale) {
    if (random.integer(0, 7) > 0) return randomShape(random, randomKind(random), scale);
    Chain chain{.points = {randomVec2(random, scale)}, .closed = random.integer(0, 1) == 1};
    const int count = random.integer(3, 4);
    while (static_cast<int>(chain.points.size()) < count) {
        const Vec2 next = chain.points.back() + randomVec2(random, scale);
        if ((next - chain.points.back()).norm() > 0.1 * scale && (next - chain.points[0]).norm() > 0.1 * scale)
            chain.points.push_back(next);
    }
    return chain;
}

Sweep anySweep(Random& random, double scale) {
    Sweep sweep;
    sweep.start = randomVec2(random, 3 * scale);
    sweep.shift = randomVec2(random, scale * placements::powerOfTen(random, -1, 1.5));
    sweep.angle = random.uniform(-3, 3);
    sweep.turn = random.integer(0, 3) == 0 ? 0 : random.uniform(-1, 1) * placements::powerOfTen(random, -1, 1);
    if (random.integer(0, 1) == 0) sweep.localCenter = randomVec2(random, scale);
    return sweep;
}

struct Swept {
    Shape a, b;
    Sweep sweepA, sweepB;
};

/// So that at some time within the step they are this far apart.
void meetAt(Swept& s, double time, double gap) {
    for (int i = 0; i < 3; ++i) {
        const Distance now = Pair(s.a, s.sweepA, s.b, s.sweepB).distanceAt(time);
        s.sweepB.start += now.normal * (gap - now.separation);
    }
}

/// Sizes of 0.1 to 3 m; one in three comes by chance, one in three touches or hardly passes at a time that is chosen,
/// and of these one in ten moves along the surface just then. One in ten lies 10 km away.
Swept anySwept(Random& random) {
    const double scale = placements::powerOfTen(random, -1, 0.5);
    Swept s{anyShape(random, scale), anyShape(random, scale), anySweep(random, scale), anySweep(random, scale)};
    const int how = random.integer(0, 29);
    if (how >= 10) {
        const double time = random.uniform(0, 1), gap = how < 20 ? 0 : placements::powerOfTen(random, -7, -1);
        meetAt(s, time, random.integer(0, 1) == 0 ? gap : -gap);
        if (how % 10 == 0) {
            const Vec2 along = perp(Pair(s.a, s.sweepA, s.b, s.sweepB).distanceAt(time).normal);
            s.sweepB.start += s.sweepB.shift * time;
            s.sweepB.shift = s.sweepA.shift + along * scale * random.uniform(-3, 3);
            s.sweepB.start -= s.sweepB.shift * time;
        }
    }
    if (random.integer(0, 9) == 0)
        for (Sweep* sweep : {&s.sweepA, &s.sweepB}) sweep->start += Vec2(1e4, -1e4);
    return s;
}

struct TouchTally {
    int hits = 0, atStart = 0, followed = 0, passing = 0, undecided = 0, faults = 0;
    double farthest = 0;  ///< at the time told [m]
    std::string first;    ///< fault
};

/// The normal parts two pieces by as much as they are apart, and the point lies half way.
bool isBetween(const Pair& pair, const Touch& touch) {
    const Transform poseA = referencePose(pair.sweepA, touch.time), poseB = referencePose(pair.sweepB, touch.time);
    const minkowski::Point normal = pointOf(touch.normal), point = pointOf(touch.point);
    for (const Shape& pieceA : pair.a)
        for (const Shape& pieceB : pair.b) {
            const minkowski::Outline a = outlineOf(pieceA, poseA), b = outlineOf(pieceB, poseB);
            const double gap = gapBetween(a, b).separation;
            // Nearest points of cores without radius are half of the tolerance apart: a rounding, of 10 km 2e-12 m,
            // turns what is between them by 1e-6 at most, and so much of the sizes the normal may miss.
            if (gap > touchTolerance + 1e-10 || std::fabs(gapAlong(a, b, normal) - gap) > 1e-5) continue;
            const double toA = distanceToBoundary(a.corners, point) - a.radius;
            const double toB = distanceToBoundary(b.corners, point) - b.radius;
            if (std::fabs(toA - 0.5 * gap) < 1e-10 && std::fabs(toB - 0.5 * gap) < 1e-10) return true;
        }
    return false;
}

const char* faultOfTouch(const Pair& pair, const std::optional<Touch>& touch, TouchTally& tally) {
    const double until = touch ? touch->time : 1;
    if (until > 0) {
        const Verdict before = verdictOn(pair, 0, until);
        tally.undecided += before == Verdict::Undecided;
        if (before == Verdict::Touching) return "missed";
    }
    if (!touch) return nullptr;
    ++tally.hits;
    if (!(touch->time >= 0 && touch->time <= 1)) return "a time beyond the step";
    if (std::fabs(touch->normal.norm() - 1) > 1e-14) return "the normal is no unit vector";
    const double gap = pair.gapAt(touch->time);
    tally.farthest = std::max(tally.farthest, gap);
    if (gap > touchTolerance + 1e-10) return "made up";
    if (touch->time == 0) return ++tally.atStart, nullptr;
    if (gap < 0.5 * touchTolerance - 1e-10) return "late";
    if (!isBetween(pair, *touch)) return "the normal or the point is not between them";
    // Where they come on at a speed, the touch itself follows as soon as that says, but of corners that just pass.
    const double moment = 0.01 * gap / pair.fastest, speed = (gap - pair.gapAt(touch->time + moment)) / moment;
    const double due = touch->time + 1.5 * gap / speed;
    ++(speed > 0.1 * pair.fastest && due <= 1 && pair.gapAt(due) <= 0 ? tally.followed : tally.passing);
    return nullptr;
}

std::string describePair(const Pair& pair, int index) {
    std::ostringstream text;
    text.precision(17);
    text << " in case " << index;
    for (const Sweep& sweep : {pair.sweepA, pair.sweepB})
        text << "\n  from (" << sweep.start.transpose() << ") by (" << sweep.shift.transpose() << "), angle "
             << sweep.angle << " by " << sweep.turn << ", about (" << sweep.localCenter.transpose() << ")";
    return text.str();
}

}  // namespace

TEST_CASE("1,000,000 swept pairs touch where fine stepping says, none missed and none made up", "[collide][sweep]") {
    Random random(73);
    TouchTally tally;
    const int count = cases(1'000'000);
    for (int i = 0; i < count; ++i) {
        const Swept s = anySwept(random);
        const Pair pair(s.a, s.sweepA, s.b, s.sweepB);
        const char* fault = faultOfTouch(pair, firstTouch(s.a, s.sweepA, s.b, s.sweepB), tally);
        if (fault && tally.faults++ == 0) tally.first = fault + describePair(pair, i);
    }
    std::cout << "[sweep] " << count << " swept pairs: " << tally.hits << " touch, " << tally.atStart
              << " of them at the start, " << tally.followed << " head on, " << tally.passing << " in passing; faults "
              << tally.faults << ", undecided " << tally.undecided << "; farthest apart at a touch " << tally.farthest
              << " m\n";
    INFO("the first fault: " << tally.first);
    CHECK(tally.faults == 0);
    CHECK(tally.undecided == 0);
    CHECK(tally.hits > count / 4);
    CHECK(count - tally.hits > count / 8);
    CHECK(tally.atStart > count / 50);
    CHECK(tally.passing < count / 10);
}

TEST_CASE("shapes that do not turn touch where a shape cast says, 20,000 times", "[collide][sweep]") {
    Random random(79);
    int hits = 0;
    double worst = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Shape a = anyShape(random, 1), b = anyShape(random, 1);
        Sweep sweepA = anySweep(random, 1), sweepB = anySweep(random, 1);
        sweepA.turn = sweepB.turn = 0;
        const Vec2 shift = sweepB.shift - sweepA.shift;
        const auto cast = castShape(b, poseAt(sweepB, 0), shift, a, poseAt(sweepA, 0));
        const auto touch = firstTouch(a, sweepA, b, sweepB, 1e-7);
        INFO("case " << i);
        if (!cast) {
            // What only passes by may be told.
            CHECK((!touch || Pair(a, sweepA, b, sweepB).gapAt(touch->time) > 0));
            continue;
        }
        REQUIRE(touch);
        ++hits;
        CHECK(touch->time <= cast->fraction + 1e-15);
        if (cast->fraction == 0) continue;
        const double closing = -cast->normal.dot(shift);
        // A corner that meets a corner does so faster than the last normal tells.
        if (closing > 0.01 * shift.norm()) worst = std::max(worst, (cast->fraction - touch->time) * closing);
    }
    std::cout << "[sweep] " << hits << " casts: at most " << worst << " m early, of 1e-7 m\n";
    CHECK(worst <= 1e-7 + 1e-14);
    CHECK(hits > 2000);
}

TEST_CASE("a rod of 2 m that turns by half a turn meets a peg of 0.1 m, 1 m above its middle, at arccos 0.1",
          "[collide][sweep]") {
    const Shape rod = Segment{{-2, 0}, {2, 0}}, peg = Circle{0.1};
    const Sweep turning{.turn = std::numbers::pi}, still{.start = {0, 1}};
    const auto touch = firstTouch(rod, turning, peg, still);
    REQUIRE(touch);
    // The peg is cos(angle) from the rod's line, and comes nearer by sin(angle) = 0.995 m a radian.
    const double angle = std::acos(0.1);
    CHECK(touch->time * std::numbers::pi <= angle);
    CHECK(touch->time * std::numbers::pi > angle - 1e-5 / 0.99);
    CHECK((touch->normal - Vec2(-std::sin(angle), std::cos(angle))).norm() < 2e-5);
    CHECK((touch->point - 0.995 * Vec2(std::cos(angle), std::sin(angle))).norm() < 2e-4);
    CHECK_FALSE(firstTouch(rod, turning, Circle{0.1}, {.start = {0, 2.2}}));
}

TEST_CASE("a disc that circles ten times around a disc, 0.1 mm off, does not touch it, 4 um off it does",
          "[collide][sweep]") {
    const Sweep circling{.turn = 20 * std::numbers::pi}, still{};
    const Shape around = Circle{0.5, {1.5, 0}};
    CHECK_FALSE(firstTouch(Circle{0.9999}, still, around, circling));
    const auto touch = firstTouch(Circle{0.999996}, still, around, circling);
    REQUIRE(touch);
    CHECK(touch->time == 0);
}

TEST_CASE("what overlaps at the start touches at 0, along the shortest way out, a chain at its deepest segment",
          "[collide][sweep]") {
    const Sweep still{}, moving{.start = {0.9, 0.2}, .shift = {5, 0}, .turn = 1};
    const auto boxes = firstTouch(boxPolygon({0.5, 0.5}), still, boxPolygon({0.5, 0.5}), moving);
    REQUIRE(boxes);
    CHECK(boxes->time == 0);
    CHECK(boxes->normal == Vec2(1, 0));
    CHECK(std::fabs(boxes->point.x() - 0.45) < 1e-15);
    const Shape corner = Chain{.points = {{-4, 0}, {0, 0}, {0, 4}}};
    const auto touch = firstTouch(corner, still, Circle{1}, {.start = {-0.2, 0.9}});
    REQUIRE(touch);
    CHECK(touch->time == 0);
    CHECK(touch->normal == Vec2(-1, 0));
}

TEST_CASE("a way between two poses goes from the one to the other, by the shorter turn", "[collide][sweep]") {
    Random random(83);
    for (int i = 0; i < 1000; ++i) {
        const Transform from{randomVec2(random, 9), turnBy(random.uniform(-9, 9))};
        const Transform to{randomVec2(random, 9), turnBy(random.uniform(-9, 9))};
        const Sweep sweep = sweepBetween(from, to, randomVec2(random, 2));
        for (const auto& [time, pose] : {std::pair{0.0, from}, std::pair{1.0, to}}) {
            const Vec2 place(1, 2);  // any point of the body
            // Some ten roundings of numbers up to 12.
            CHECK((poseAt(sweep, time) * place - pose * place).norm() < 2e-14);
        }
        CHECK(std::fabs(sweep.turn) <= std::numbers::pi);
    }
}

TEST_CASE("a sweep refuses what is not finite, and a tolerance that is not positive", "[collide][sweep]") {
    const Shape disc = Circle{1};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(firstTouch(disc, {.start = {nan, 0}}, disc, {}),
                      "firstTouch.sweepA.start: (nan, 0) is not finite");
    CHECK_THROWS_WITH(firstTouch(disc, {}, disc, {.turn = nan}), "firstTouch.sweepB.turn: nan is not finite");
    CHECK_THROWS_WITH(firstTouch(disc, {}, disc, {}, 0), "firstTouch.tolerance: 0 is not positive");
    CHECK_THROWS_WITH(sweepBetween({{nan, 0}, {}}, {}), "sweepBetween.start: (nan, 0) is not finite");
}

TEST_CASE("a sweep of any numbers up to 1e75 ends, and larger ones are refused", "[collide][sweep]") {
    const Shape box = boxPolygon({1, 1}), disc = Circle{1, {1, 0}};
    for (const double size : {1e-320, 1e12, 1e50, 1e75, 1.01e75, 1e160, 1.7e308})
        for (const Sweep& sweep :
             {Sweep{.start = {3, size}}, Sweep{.start = {3, 0}, .shift = {size, -size}},
              Sweep{.start = {3.1, 0}, .turn = size}, Sweep{.start = {3.1, 0}, .localCenter = {size, 1}}})
            for (const Shape& shape : {box, disc}) {
                INFO("of " << size);
                if (size > 1e75) {
                    CHECK_THROWS_AS(firstTouch(box, {}, shape, sweep), std::invalid_argument);
                    continue;
                }
                const auto touch = firstTouch(box, {}, shape, sweep);
                CHECK((!touch || (touch->time >= 0 && touch->time <= 1)));
            }
}
