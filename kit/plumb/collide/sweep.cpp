// SPDX-License-Identifier: MIT
#include <plumb/collide/sweep.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <plumb/collide/detail/outline.h>
#include <plumb/collide/detail/sweep_limits.h>
#include <plumb/collide/distance.h>
#include <plumb/collide/overlap.h>
#include <plumb/math/check.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

/// Shapes this near count as having arrived, which saves the last of ever smaller steps [m].
constexpr double distanceTolerance = 1e-5;

/// Limit on the number of steps. A rod that turns three times takes a few hundred.
constexpr int maxAdvances = 500;

/// The same for firstTouch: a disc that circles another ten times, 0.1 mm away, takes about five thousand.
constexpr int maxTouchSteps = 10'000;

/// Lower bound of a point's position along a direction after some time: position + velocity t - maxAcceleration / 2
/// t^2.
struct MotionBound {
    double position = 0, velocity = 0, maxAcceleration = 0;  ///< [m], [m], [m], each by the step
    double at(double time) const { return position + (velocity - 0.5 * maxAcceleration * time) * time; }
};

/// Lower bounds for all corners of a moving shape along a direction.
class CornerBounds {
public:
    CornerBounds(const Outline& outline, const Vec2& center, const Sweep& sweep, const Vec2& direction)
        : count_(outline.count) {
        const double drift = sweep.shift.dot(direction);
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 arm = outline.corners[i] - center;
            const double maxAcceleration = sweep.turn * sweep.turn * std::sqrt(arm.dot(arm));
            corners_[i] = {outline.corners[i].dot(direction), drift + sweep.turn * perp(arm).dot(direction),
                           maxAcceleration};
        }
    }
    /// The corner with the lowest bound at this time.
    MotionBound lowest(double time) const {
        std::size_t least = 0;
        for (std::size_t i = 1; i < count_; ++i)
            if (corners_[i].at(time) < corners_[least].at(time)) least = i;
        return corners_[least];
    }

private:
    std::size_t count_;
    std::array<MotionBound, maxPolygonVertices> corners_;
};

/// How long two cores surely stay farther apart than this distance: until the bound s of the header has come down to
/// it. Chords approach that time from below. Returns left when that is sooner.
double timeApart(const CornerBounds& a, const CornerBounds& b, double distance, double left) {
    double time = 0;
    for (int i = 0; i < 3; ++i) {
        const MotionBound lowestA = a.lowest(time), lowestB = b.lowest(time);
        const MotionBound pair{lowestA.position + lowestB.position - distance, lowestA.velocity + lowestB.velocity,
                               lowestA.maxAcceleration + lowestB.maxAcceleration};
        const double gap = pair.at(time), closing = pair.maxAcceleration * time - pair.velocity;
        if (!(gap > 0)) break;
        // At that time these two corners are surely so near.
        const double fastest = closing + std::sqrt(closing * closing + 2 * pair.maxAcceleration * gap);
        const double far = 2 * gap < fastest * (left - time) ? time + 2 * gap / fastest : left;
        const double gapThen = a.lowest(far).at(far) + b.lowest(far).at(far) - distance;
        if (gapThen >= 0) return far;
        time += (far - time) * (gap / (gap - gapThen));
    }
    return time;
}

/// For convex shapes, before the given end time.
std::optional<Touch> touchOf(const Shape& a, const Sweep& sweepA, const Shape& b, const Sweep& sweepB, double tolerance,
                             double end) {
    double time = 0;
    for (int i = 0;; ++i) {
        const Transform poseA = poseAt(sweepA, time), poseB = poseAt(sweepB, time);
        const Vec2& origin = poseA.position;
        const Outline outlineA = outlineOf(a, poseA, origin), outlineB = outlineOf(b, poseB, origin);
        const Distance core = coreDistance(outlineA, outlineB);
        const double radii = outlineA.radius + outlineB.radius, separation = core.separation - radii;
        if (!std::isfinite(separation)) return std::nullopt;
        const Vec2 middle = core.pointA + core.normal * (outlineA.radius + 0.5 * separation);
        const Touch touch{time, origin + middle, core.normal};
        if (separation <= tolerance || i == maxTouchSteps) return touch;
        const CornerBounds boundsA(outlineA, sweepA.start + sweepA.shift * time - origin, sweepA, -core.normal);
        const CornerBounds boundsB(outlineB, sweepB.start + sweepB.shift * time - origin, sweepB, core.normal);
        // Half of the tolerance is left between them, so that the normal is well defined.
        const double apart = timeApart(boundsA, boundsB, radii + 0.5 * tolerance, end - time);
        if (!(apart < end - time)) return std::nullopt;
        if (!(time + apart > time)) return touch;
        time += apart;
    }
}

/// Contains a piece of a shape during the whole sweep.
Aabb sweptBox(const Shape& piece, const Sweep& sweep) {
    const Outline outline = outlineOf(piece, {}, sweep.localCenter);
    double turningRadius = 0;
    for (std::size_t i = 0; i < outline.count; ++i) turningRadius = std::max(turningRadius, outline.corners[i].norm());
    const Vec2 end = sweep.start + sweep.shift;
    return inflate({sweep.start.cwiseMin(end), sweep.start.cwiseMax(end)}, turningRadius + outline.radius);
}

}  // namespace

void validate(const Sweep& sweep, const std::string& name) {
    requireInRange(sweep.start, name, ".start");
    requireInRange(sweep.shift, name, ".shift");
    requireFinite(sweep.angle, name, ".angle");
    requireWithin(sweep.turn, -maxMagnitude, maxMagnitude, name, ".turn");
    requireInRange(sweep.localCenter, name, ".localCenter");
}

Sweep partOf(const Sweep& sweep, double from, double to) {
    return {sweep.start + sweep.shift * from, sweep.shift * (to - from), sweep.angle + sweep.turn * from,
            sweep.turn * (to - from), sweep.localCenter};
}

Sweep sweepBetween(const Transform& start, const Transform& end, const Vec2& localCenter) {
    const Rot turn = start.rotation.inverse() * end.rotation;
    const Vec2 from = start * localCenter;
    const Sweep sweep{from, end * localCenter - from, start.rotation.angle(), turn.angle(), localCenter};
    requireFinite(sweep.start, "sweepBetween.start");
    requireFinite(sweep.shift, "sweepBetween.shift");
    requireFinite(sweep.angle, "sweepBetween.angle");
    requireFinite(sweep.turn, "sweepBetween.turn");
    requireFinite(sweep.localCenter, "sweepBetween.localCenter");
    return sweep;
}

std::optional<Touch> firstTouch(const Shape& a, const Sweep& sweepA, const Shape& b, const Sweep& sweepB,
                                double tolerance) {
    requireInRange(a, "firstTouch.a");
    validate(sweepA, "firstTouch.sweepA");
    requireInRange(b, "firstTouch.b");
    validate(sweepB, "firstTouch.sweepB");
    requirePositive(tolerance, "firstTouch.tolerance");
    if (!hasPieces(a) && !hasPieces(b)) return touchOf(a, sweepA, b, sweepB, tolerance, 1);
    // If several pieces overlap at the start, the deepest.
    if (const std::optional<Overlap> deep = overlap(a, poseAt(sweepA, 0), b, poseAt(sweepB, 0)))
        return Touch{0, 0.5 * deep->pointA + 0.5 * deep->pointB, deep->normal};
    std::optional<Touch> first;
    const std::vector<Shape> piecesB = piecesOf(b);
    std::vector<Aabb> boxesB;
    for (const Shape& pieceB : piecesB) boxesB.push_back(sweptBox(pieceB, sweepB));
    for (const Shape& pieceA : piecesOf(a)) {
        const Aabb boxA = inflate(sweptBox(pieceA, sweepA), tolerance);
        for (std::size_t i = 0; i < piecesB.size(); ++i) {
            if (!overlap(boxA, boxesB[i])) continue;
            const auto touch = touchOf(pieceA, sweepA, piecesB[i], sweepB, tolerance, first ? first->time : 1);
            if (touch && (!first || touch->time < first->time)) first = touch;
        }
    }
    return first;
}

Transform poseAt(const Sweep& sweep, double time) {
    const Rot rotation = Rot::fromAngle(sweep.angle + sweep.turn * time);
    return {sweep.start + sweep.shift * time - rotation * sweep.localCenter, rotation};
}

std::optional<double> timeOfApproach(const SweptShape& a, const SweptShape& b, double limit, double from) {
    const Vec2 shift = b.sweep.shift - a.sweep.shift;
    const Vec2 between = b.sweep.start - a.sweep.start;
    const double farthest = std::max(between.norm(), (between + shift).norm());
    const double turning = std::fabs(b.sweep.turn - a.sweep.turn) * b.turningRadius;
    const double maxAcceleration = std::fabs(a.sweep.turn) * (2 * shift.norm() + std::fabs(a.sweep.turn) * farthest);
    double time = from;
    for (int i = 0; i < maxAdvances; ++i) {
        const Distance now = distance(*a.shape, poseAt(a.sweep, time), *b.shape, poseAt(b.sweep, time));
        const double room = now.separation - limit;
        if (room <= distanceTolerance) return time;
        const Vec2 apart = between + shift * time;
        const double closing = (perp(apart) * a.sweep.turn - shift).dot(now.normal) + turning;
        const double fastest = closing + std::sqrt(closing * closing + 2 * maxAcceleration * room);
        if (!(fastest * (1 - time) > 2 * room)) return std::nullopt;
        time += 2 * room / fastest;
    }
    return time;
}

}  // namespace plumb
