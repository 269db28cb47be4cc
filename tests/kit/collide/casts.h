// SPDX-License-Identifier: MIT
// Is this where a shape that is shifted first meets another? Judged by the Minkowski difference alone.
#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include <plumb/collide/ray_cast.h>

#include "kit/collide/placed_outline.h"

namespace casts {

using minkowski::Outline;
using minkowski::Point;

struct Case {
    Outline target, moving;
    Point shift;
    double size = 1;  ///< of the numbers that go in [m]
};

inline double gapAt(const Case& c, double fraction) {
    return gapBetween(c.target, shifted(c.moving, c.shift * fraction)).separation;
}

/// Of convex shapes the gap is a convex function of the fraction: thirds close in on its least.
inline double leastGap(const Case& c) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool before = gapAt(c, a) < gapAt(c, b);
        (before ? high : low) = before ? b : a;
    }
    return std::min({gapAt(c, low), gapAt(c, 0), gapAt(c, 1)});
}

/// A line along the way lies between the two: a short proof that they never meet.
inline bool passesBeside(const Case& c) {
    const double way = length(c.shift);
    const Point aside = way > 0 ? Point{-c.shift.y, c.shift.x} * (1 / way) : Point{0, 1};
    return gapAlong(c.target, c.moving, aside) > 0 || gapAlong(c.target, c.moving, aside * -1) > 0;
}

/// Thirty roundings of the largest numbers: to turn, shift, subtract, project, and come back from a fraction takes
/// about ten, here as there; a root adds some.
inline double toleranceOf(const Case& c) {
    return 30 * std::numeric_limits<double>::epsilon() / 2 * c.size;
}

/// Are they deep in each other somewhere on the way?
inline bool surelyMeet(const Case& c) {
    return !passesBeside(c) && leastGap(c) < -toleranceOf(c);
}

inline const char* faultOfHit(const Case& c, const plumb::CastPoint& hit) {
    const double tolerance = toleranceOf(c), way = length(c.shift), start = gapAt(c, 0);
    const Point normal = pointOf(hit.normal);
    if (std::fabs(length(normal) - 1) > 1e-15) return "the normal is not a unit vector";
    if (!(hit.fraction >= 0 && hit.fraction <= 1)) return "the fraction is not within 0 to 1";
    if (start < -tolerance && hit.fraction > 0) return "it began inside";
    if (hit.fraction == 0 && start <= tolerance) {
        const bool against = length(normal + c.shift * (1 / way)) < 1e-15;
        return start > -tolerance || way == 0 || against ? nullptr : "the normal is not against the motion";
    }
    if (std::fabs(gapAt(c, hit.fraction)) > tolerance) return "they do not touch there";
    if (dot(normal, c.shift) > tolerance) return "the normal goes with the motion";
    const Outline met = shifted(c.moving, c.shift * hit.fraction);
    const double radii = c.target.radius + c.moving.radius;
    // As seen from so near, a place that is a rounding off is another direction.
    const double blur = radii > 0 ? std::min(1.0, tolerance / radii) * c.size : 0;
    if (gapAlong(c.target, met, normal) < -2 * tolerance - blur) return "the normal does not part them";
    const Point point = pointOf(hit.point);
    if (std::fabs(distanceToBoundary(c.target.corners, point - normal * c.target.radius)) > 2 * tolerance + blur)
        return "the point is not of the outline";
    // The gap is convex: what is positive just before has not been zero earlier.
    const double before = hit.fraction - 4 * tolerance / std::max(-dot(normal, c.shift), 1e-300);
    return before > 0 && gapAt(c, before) <= 0 ? "they touched before" : nullptr;
}

/// Null when the cast is right.
inline const char* faultOf(const Case& c, const std::optional<plumb::CastPoint>& hit) {
    if (hit) return faultOfHit(c, *hit);
    return surelyMeet(c) ? "missed" : nullptr;
}

}  // namespace casts
