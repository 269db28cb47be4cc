// SPDX-License-Identifier: MIT
// The reference of the other tests is itself held against something plainer: trying every direction.
#include "kit/collide/minkowski.h"

#include <numbers>

#include "catch.h"
#include "kit/collide/placements.h"

namespace {

using minkowski::Outline;
using minkowski::Point;

Point directionAt(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// The highest gap near an angle, by thirds; below 1e-9 rad nothing changes any more.
double climb(const Outline& a, const Outline& b, double low, double high) {
    while (high - low > 1e-9) {
        const double third = (high - low) / 3;
        const bool upper = gapAlong(a, b, directionAt(low + third)) < gapAlong(a, b, directionAt(high - third));
        (upper ? low : high) += upper ? third : -third;
    }
    return gapAlong(a, b, directionAt((low + high) / 2));
}

/// The largest gap over all directions: a look around, then up every hill.
double gapByLookingAround(const Outline& a, const Outline& b) {
    constexpr int looks = 2000;
    constexpr double step = 2 * std::numbers::pi / looks;
    std::vector<double> seen;
    for (int i = 0; i < looks; ++i) seen.push_back(gapAlong(a, b, directionAt(i * step)));
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < looks; ++i) {
        const double here = seen[i], before = seen[(i + looks - 1) % looks], behind = seen[(i + 1) % looks];
        if (here < before || here < behind) continue;
        const double angle = static_cast<double>(i) * step;
        highest = std::max({highest, here, climb(a, b, angle - step, angle + step)});
    }
    return highest;
}

}  // namespace

TEST_CASE("the Minkowski difference gives the gap that is largest over 2,000 directions and finer ones", "[collide]") {
    plumb::Random random(7);
    double worst = 0;
    for (int i = 0; i < 600; ++i) {
        const Placement p = randomPlacement(random, kinds[static_cast<std::size_t>(i) % kinds.size()],
                                            kinds[static_cast<std::size_t>(i / 7) % kinds.size()]);
        if (p.regime == Regime::Flush) continue;  // two hills nearer to each other than the look is fine
        const Outline a = outlineOf(p.a, {}), b = outlineOf(p.b, p.bInA);
        worst = std::max(worst, std::fabs(gapBetween(a, b).separation - gapByLookingAround(a, b)) / p.size);
    }
    // The climb ends 1e-9 rad wide, and a gap changes by at most the size times the angle.
    CAPTURE(worst);
    CHECK(worst < 1e-9);
}

TEST_CASE("a square 3 m to the right of a square of the same 2 m width is 1 m away, and one 1.5 m up 0.5 m inside",
          "[collide]") {
    const Outline square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0};
    const minkowski::Gap right = gapBetween(square, shifted(square, {3, 0.5}));
    CHECK(right.separation == 1);
    CHECK(right.normal.x == 1);
    const minkowski::Gap up = gapBetween(square, shifted(square, {0.25, 1.5}));
    CHECK(up.separation == -0.5);
    CHECK(up.normal.y == 1);
    const minkowski::Gap corner = gapBetween(square, shifted(square, {5, 6}));
    CHECK(corner.separation == 5);  // 3-4-5
    CHECK(std::fabs(corner.normal.x - 0.6) < 1e-15);
}
