// SPDX-License-Identifier: MIT
// Which placed shapes put distances and overlaps to the test?
#pragma once
#include <limits>

#include "kit/collide/placed_outline.h"
#include "kit/collide/placements.h"

struct Placed {
    plumb::Shape a, b;
    plumb::Transform poseA, poseB;
    double size = 1;  ///< of the numbers that go in [m]
};

inline Placed randomPlaced(plumb::Random& random, Kind kindA, Kind kindB) {
    Placed p;
    const Regime regime = static_cast<Regime>(random.integer(0, regimes - 1));
    const double scale = 0.05 * std::pow(100, random.uniform(0, 1));
    p.a = randomShape(random, kindA, scale);
    p.b = randomShape(random, kindB, scale * random.uniform(0.3, 3));
    if (regime == Regime::Degenerate && kindA == kindB && random.integer(0, 1) == 0) p.b = p.a;
    p.poseA.rotation = turnBy(random.uniform(0, 2 * std::numbers::pi));
    double angle = random.uniform(0, 2 * std::numbers::pi);
    if (regime == Regime::Flush) angle = placements::flushAngle(random, outlineOf(p.a, p.poseA), outlineOf(p.b, {}));
    p.poseB.rotation = turnBy(angle);
    if (regime == Regime::Degenerate) {
        p.poseA.rotation = {0, 1};
        p.poseB.rotation = random.integer(0, 1) == 0 ? plumb::Rot{0, -1} : plumb::Rot{-1, 0};
    }
    const minkowski::Point place =
        placements::place(random, regime, outlineOf(p.a, p.poseA), outlineOf(p.b, p.poseB), scale);
    p.poseA.position = randomVec2(random, scale);
    p.poseB.position = p.poseA.position + plumb::Vec2(place.x, place.y);
    p.size = largestNumber(p.a) + largestNumber(p.b) + p.poseA.position.norm() + p.poseB.position.norm();
    return p;
}

/// Ten roundings of the largest numbers: to turn, shift, subtract and project takes about five, here as there.
inline double toleranceOf(const Placed& p) {
    return 10 * std::numeric_limits<double>::epsilon() / 2 * p.size;
}
