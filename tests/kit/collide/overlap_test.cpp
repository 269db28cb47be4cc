// SPDX-License-Identifier: MIT
#include <plumb/collide/overlap.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include <plumb/shapes/chain.h>

#include "cases.h"
#include "catch.h"
#include "kit/collide/placed_pair.h"
#include "numbers.h"

namespace {

using minkowski::Gap;
using minkowski::Outline;
using namespace plumb;
using namespace plumb::test;

/// Null when the answer is right for two convex outlines.
const char* faultOfOverlap(const Outline& a, const Outline& b, const std::optional<Overlap>& found, double tolerance,
                           double size) {
    const double gap = gapBetween(a, b).separation;
    if (!found) return gap < -tolerance ? "missed" : nullptr;
    if (gap > tolerance) return "made up";
    if (!(found->depth >= 0)) return "a negative depth";
    if (std::fabs(found->depth + gap) > tolerance) return "the depth is wrong";
    if (std::fabs(found->normal.norm() - 1) > 1e-14) return "the normal is no unit vector";
    // Shifted by the depth along the normal, B just touches A; but where corners of the cores nearly meet, the
    // direction is as good as the places are, seen from so near.
    const double blur = tolerance / std::max(std::fabs(gap + a.radius + b.radius), 1e-300);
    const Outline parted = shifted(b, pointOf(found->normal) * found->depth);
    if (blur < 0.1 && std::fabs(gapBetween(a, parted).separation) > 2 * tolerance + blur * size)
        return "it does not part them";
    if ((found->pointA - found->normal * found->depth - found->pointB).norm() > tolerance)
        return "the points do not fit";
    return nullptr;
}

}  // namespace

TEST_CASE("two shapes overlap, and as deep, as the Minkowski difference says, 1,000,000 times", "[collide][overlap]") {
    Random random(89);
    const int count = cases(1'000'000);
    int found = 0, faults = 0, lopsided = 0;
    double worst = 0;
    std::string first;
    for (int i = 0; i < count; ++i) {
        const Placed p = randomPlaced(random, randomKind(random), randomKind(random));
        const std::optional<Overlap> here = overlap(p.a, p.poseA, p.b, p.poseB);
        const Outline a = outlineOf(p.a, p.poseA), b = outlineOf(p.b, p.poseB);
        const char* fault = faultOfOverlap(a, b, here, toleranceOf(p), p.size);
        if (fault && faults++ == 0) first = fault + (" in case " + std::to_string(i));
        if (!here) continue;
        ++found;
        worst = std::max(worst, std::fabs(here->depth + gapBetween(a, b).separation) / toleranceOf(p));
        // The other way round it is as deep.
        const std::optional<Overlap> back = overlap(p.b, p.poseB, p.a, p.poseA);
        lopsided += !back ? here->depth > toleranceOf(p) : std::fabs(back->depth - here->depth) > toleranceOf(p);
    }
    std::cout << "[overlap] " << found << " of " << count << " overlap, " << faults << " faults; depths right to "
              << worst << " of ten roundings of the sizes\n";
    INFO("the first fault: " << first);
    CHECK(faults == 0);
    CHECK(lopsided == 0);
    CHECK(found > count / 4);
    CHECK(count - found > count / 4);
}

TEST_CASE("a chain is as deep as the deepest of its segments, 20,000 times", "[collide][overlap]") {
    Random random(97);
    int found = 0;
    for (int i = 0; i < 20'000; ++i) {
        Chain chain;
        for (int k = random.integer(2, 9); k > 0; --k) chain.points.push_back(randomVec2(random, 2));
        chain.closed = chain.points.size() > 2 && random.integer(0, 1) == 1;
        const Shape other = randomShape(random, randomKind(random), 0.5);
        const Transform pose{randomVec2(random, 2), turnBy(random.uniform(-3, 3))};
        double least = infinity;
        for (const Shape& piece : piecesOf(chain))
            least = std::min(least, gapBetween(outlineOf(piece, {}), outlineOf(other, pose)).separation);
        const std::optional<Overlap> here = overlap(chain, {}, other, pose);
        INFO("case " << i);
        REQUIRE(here.has_value() == (least <= 0));
        if (!here) continue;
        ++found;
        CHECK(std::fabs(here->depth + least) < 1e-14);
        const std::optional<Overlap> back = overlap(other, pose, chain, {});
        CHECK((back && std::fabs(back->depth - here->depth) < 1e-14));
    }
    CHECK(found > 4000);
}

TEST_CASE("two boxes of 1 m overlap at 0.9 m by 0.1 m, touch at 1 m, and not at 1.001 m", "[collide][overlap]") {
    const Shape box = boxPolygon({0.5, 0.5});
    const auto at = [&](double x) { return overlap(box, {}, box, {{x, 0.2}, {}}); };
    REQUIRE(at(0.9));
    CHECK(std::fabs(at(0.9)->depth - 0.1) < 1e-15);
    CHECK(at(0.9)->normal == Vec2(1, 0));
    REQUIRE(at(1));
    CHECK(at(1)->depth == 0);
    CHECK_FALSE(at(1.001));
    CHECK(at(-0.9)->normal == Vec2(-1, 0));
}

TEST_CASE("what is not finite overlaps nothing", "[collide][overlap]") {
    const Shape disc = Circle{1}, chain = Chain{.points = {{-1, 0}, {1, 0}}};
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity})
        for (const Shape& shape : {disc, chain}) {
            CHECK_FALSE(overlap(shape, {{bad, 0}, {}}, disc, {}));
            CHECK_FALSE(overlap(disc, {}, shape, {{0, bad}, {}}));
            CHECK_FALSE(overlap(disc, {}, shape, {{0, 0}, {bad, bad}}));
        }
}
