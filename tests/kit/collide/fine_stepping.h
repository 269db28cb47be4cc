// SPDX-License-Identifier: MIT
// Do two shapes on their ways touch before a time? Seen by looking often enough, and by nothing that the sweep knows.
#pragma once
#include <cmath>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/collide/sweep.h>
#include <plumb/shapes/chain.h>

#include "kit/collide/placed_outline.h"

namespace fine_stepping {

using plumb::Shape;
using plumb::Sweep;
using plumb::Transform;
using plumb::Vec2;

/// By the standard library's sine and cosine.
inline Transform referencePose(const Sweep& sweep, double time) {
    const plumb::Rot rotation = turnBy(sweep.angle + sweep.turn * time);
    return {sweep.start + sweep.shift * time - rotation * sweep.localCenter, rotation};
}

/// No point of the shape's core is farther from the point that it turns about.
inline double reachOf(const std::vector<Shape>& pieces, const Vec2& center) {
    double reach = 0;
    for (const Shape& piece : pieces)
        for (const minkowski::Point corner : outlineOf(piece, {}).corners)
            reach = std::max(reach, length(corner - pointOf(center)));
    return reach;
}

struct Pair {
    std::vector<Shape> a, b;
    Sweep sweepA, sweepB;
    double fastest = 0;  ///< the distance changes by no more than this in the step [m]

    Pair(const Shape& shapeA, const Sweep& ofA, const Shape& shapeB, const Sweep& ofB)
        : a(plumb::piecesOf(shapeA)), b(plumb::piecesOf(shapeB)), sweepA(ofA), sweepB(ofB) {
        fastest = (sweepB.shift - sweepA.shift).norm() + std::fabs(sweepA.turn) * reachOf(a, sweepA.localCenter) +
                  std::fabs(sweepB.turn) * reachOf(b, sweepB.localCenter);
    }

    /// Signed, of the nearest pieces: distance() is held to the Minkowski difference by a test of its own.
    plumb::Distance distanceAt(double time) const {
        const Transform poseA = referencePose(sweepA, time), poseB = referencePose(sweepB, time);
        plumb::Distance nearest;
        nearest.separation = std::numeric_limits<double>::infinity();
        for (const Shape& pieceA : a)
            for (const Shape& pieceB : b) {
                const plumb::Distance here = plumb::distance(pieceA, poseA, pieceB, poseB);
                if (here.separation < nearest.separation) nearest = here;
            }
        return nearest;
    }
    double gapAt(double time) const { return distanceAt(time).separation; }
};

enum class Verdict { Apart, Touching, Undecided };

/// Apart between two times, if the gap in the middle is too large to close on the way to either end; else both halves
/// are looked at. Undecided when neither is told by steps in which the gap changes by less than a hundredth of a
/// micron.
inline Verdict verdictOn(const Pair& pair, double from, double to) {
    const double middle = 0.5 * (from + to), change = 0.5 * pair.fastest * (to - from);
    const double gap = pair.gapAt(middle);
    if (gap > change) return Verdict::Apart;
    if (gap <= 0) return Verdict::Touching;
    if (change < 1e-8) return Verdict::Undecided;
    const Verdict first = verdictOn(pair, from, middle);
    return first == Verdict::Apart ? verdictOn(pair, middle, to) : first;
}

}  // namespace fine_stepping
