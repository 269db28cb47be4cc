// SPDX-License-Identifier: MIT
#include <plumb/collide/shape_cast.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <plumb/collide/detail/outline.h>
#include <plumb/collide/distance.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

/// Twice the steps of the slowest case: where the two just graze, half of the distance is left after each step.
constexpr int maxSteps = 100;

double largestOf(const Outline& outline) {
    double largest = outline.radius;
    for (std::size_t i = 0; i < outline.count; ++i)
        largest = std::max(largest, outline.corners[i].cwiseAbs().maxCoeff());
    return largest;
}

/// Two shapes nearer than this touch: eight roundings of the largest input, as distance makes five [m].
double touchOf(const Outline& target, const Outline& moving, const Vec2& shift) {
    constexpr double eightRoundings = 4 * std::numeric_limits<double>::epsilon();
    return eightRoundings * (largestOf(target) + largestOf(moving) + shift.cwiseAbs().maxCoeff());
}

std::optional<CastPoint> overlapping(const Distance& now, const Vec2& point, const Vec2& shift) {
    const double length = std::sqrt(shift.dot(shift));
    return CastPoint{point, length > 0 ? Vec2(-shift / length) : now.normal, 0};
}

/// The outlines of convex shapes relative to one origin, as is the resulting point.
std::optional<CastPoint> castOutline(Outline moving, const Vec2& shift, const Outline& target) {
    std::array<Vec2, maxPolygonVertices> start;  // of its corners
    std::copy_n(moving.corners.begin(), moving.count, start.begin());
    const double radii = target.radius + moving.radius, touch = touchOf(target, moving, shift);
    double fraction = 0;
    Vec2 normal{0, 0};
    for (int i = 0; i < maxSteps; ++i) {
        for (std::size_t k = 0; k < moving.count; ++k) moving.corners[k] = start[k] + shift * fraction;
        const Distance now = coreDistance(target, moving);
        const double separation = now.separation - radii;
        const Vec2 point = now.pointA + now.normal * target.radius;
        // With NaN no edge is outside: the shapes seem infinitely deep.
        if (i == 0 && !std::isfinite(separation)) return std::nullopt;
        if (i == 0 && separation <= 0) return overlapping(now, point, shift);
        // Where corners touch, their difference has no direction; the one of the step before separates the two as well.
        const bool blurred = i > 0 && radii < 1e3 * touch;
        if (separation <= touch) return CastPoint{point, blurred ? normal : now.normal, fraction};
        const double closing = -now.normal.dot(shift);
        if (!(closing > 0) || separation > closing * (1 - fraction) + touch) return std::nullopt;
        const double next = std::min(fraction + separation / closing, 1.0);
        normal = now.normal;
        if (!(next > fraction)) return CastPoint{point, normal, fraction};
        fraction = next;
    }
    return std::nullopt;
}

}  // namespace

std::optional<CastPoint> castShape(const Shape& moving, const Transform& pose, const Vec2& shift, const Shape& target,
                                   const Transform& targetPose) {
    const Vec2& origin = targetPose.position;
    std::optional<CastPoint> first;
    const auto meet = [&](const Shape& movingPiece, const Shape& targetPiece) {
        const std::optional<CastPoint> here =
            castOutline(outlineOf(movingPiece, pose, origin), shift, outlineOf(targetPiece, targetPose, origin));
        if (here && (!first || here->fraction < first->fraction)) first = here;
    };
    if (!hasPieces(moving) && !hasPieces(target)) {
        meet(moving, target);
    } else {
        for (const Shape& movingPiece : piecesOf(moving))
            for (const Shape& targetPiece : piecesOf(target)) meet(movingPiece, targetPiece);
    }
    if (first) first->point += origin;
    return first;
}

}  // namespace plumb
