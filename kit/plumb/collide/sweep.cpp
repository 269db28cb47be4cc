// SPDX-License-Identifier: MIT
#include <plumb/collide/sweep.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <plumb/collide/detail/outline.h>
#include <plumb/collide/detail/reach.h>
#include <plumb/collide/distance.h>
#include <plumb/collide/overlap.h>
#include <plumb/math/check.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

/// So much nearer counts as there already: what saves the last of ever smaller steps [m].
constexpr double early = 1e-5;

/// A search with more steps than this goes no further. One at a rod that turns three times takes some hundred.
constexpr int mostAdvances = 500;

/// The same, of firstTouch: one at a disc that circles another ten times, 0.1 mm off, takes some five thousand.
constexpr int mostTouchSteps = 10'000;

/// How far ahead along a direction something is after a while: place + speed t - bend / 2 t^2, or farther.
struct Ahead {
    double place = 0, speed = 0, bend = 0;  ///< [m], [m], [m], each by the step
    double at(double time) const { return place + (speed - 0.5 * bend * time) * time; }
};

/// All corners of a shape on its way, along a direction.
class Front {
public:
    Front(const Outline& outline, const Vec2& center, const Way& way, const Vec2& direction) : count_(outline.count) {
        const double drift = way.shift.dot(direction);
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 arm = outline.corners[i] - center;
            const double bend = way.turn * way.turn * std::sqrt(arm.dot(arm));
            corners_[i] = {outline.corners[i].dot(direction), drift + way.turn * perp(arm).dot(direction), bend};
        }
    }
    /// The corner that may be least far ahead, then.
    Ahead hindmost(double time) const {
        std::size_t least = 0;
        for (std::size_t i = 1; i < count_; ++i)
            if (corners_[i].at(time) < corners_[least].at(time)) least = i;
        return corners_[least];
    }

private:
    std::size_t count_;
    std::array<Ahead, maxPolygonVertices> corners_;
};

/// How long two cores surely stay farther apart than this, as they are now: until the bound s of the header has come
/// down to it, which chords approach from its near side. left when that is sooner.
double timeApart(const Front& a, const Front& b, double distance, double left) {
    double time = 0;
    for (int i = 0; i < 3; ++i) {
        const Ahead behindA = a.hindmost(time), aheadB = b.hindmost(time);
        const Ahead pair{behindA.place + aheadB.place - distance, behindA.speed + aheadB.speed,
                         behindA.bend + aheadB.bend};
        const double gap = pair.at(time), closing = pair.bend * time - pair.speed;
        if (!(gap > 0)) break;
        // No later than these two corners come so near.
        const double fastest = closing + std::sqrt(closing * closing + 2 * pair.bend * gap);
        const double far = 2 * gap < fastest * (left - time) ? time + 2 * gap / fastest : left;
        const double gapThen = a.hindmost(far).at(far) + b.hindmost(far).at(far) - distance;
        if (gapThen >= 0) return far;
        time += (far - time) * (gap / (gap - gapThen));
    }
    return time;
}

/// Of convex shapes, before the end of the time that is given.
std::optional<Touch> touchOf(const Shape& a, const Way& wayA, const Shape& b, const Way& wayB, double tolerance,
                             double end) {
    double time = 0;
    for (int i = 0;; ++i) {
        const Transform poseA = poseOn(wayA, time), poseB = poseOn(wayB, time);
        const Vec2& origin = poseA.position;
        const Outline outlineA = outlineOf(a, poseA, origin), outlineB = outlineOf(b, poseB, origin);
        const Distance core = coreDistance(outlineA, outlineB);
        const double radii = outlineA.radius + outlineB.radius, separation = core.separation - radii;
        if (!std::isfinite(separation)) return std::nullopt;
        const Vec2 middle = core.pointA + core.normal * (outlineA.radius + 0.5 * separation);
        const Touch touch{time, origin + middle, core.normal};
        if (separation <= tolerance || i == mostTouchSteps) return touch;
        const Front frontA(outlineA, wayA.start + wayA.shift * time - origin, wayA, -core.normal);
        const Front frontB(outlineB, wayB.start + wayB.shift * time - origin, wayB, core.normal);
        // Half of the tolerance is left between them, so that a normal can be told.
        const double apart = timeApart(frontA, frontB, radii + 0.5 * tolerance, end - time);
        if (!(apart < end - time)) return std::nullopt;
        if (!(time + apart > time)) return touch;
        time += apart;
    }
}

/// Holds a piece of a shape all the way.
Aabb sweptBox(const Shape& piece, const Way& way) {
    const Outline outline = outlineOf(piece, {}, way.localCenter);
    double reach = 0;
    for (std::size_t i = 0; i < outline.count; ++i) reach = std::max(reach, outline.corners[i].norm());
    const Vec2 end = way.start + way.shift;
    return inflate({way.start.cwiseMin(end), way.start.cwiseMax(end)}, reach + outline.radius);
}

}  // namespace

Way partOf(const Way& way, double from, double to) {
    return {way.start + way.shift * from, way.shift * (to - from), way.angle + way.turn * from, way.turn * (to - from),
            way.localCenter};
}

Way wayBetween(const Transform& start, const Transform& end, const Vec2& localCenter) {
    const Rot turn = start.rotation.inverse() * end.rotation;
    const Vec2 from = start * localCenter;
    const Way way{from, end * localCenter - from, start.rotation.angle(), turn.angle(), localCenter};
    requireFinite(way.start, "wayBetween.start");
    requireFinite(way.shift, "wayBetween.shift");
    requireFinite(way.angle, "wayBetween.angle");
    requireFinite(way.turn, "wayBetween.turn");
    requireFinite(way.localCenter, "wayBetween.localCenter");
    return way;
}

std::optional<Touch> firstTouch(const Shape& a, const Way& wayA, const Shape& b, const Way& wayB, double tolerance) {
    requireReach(a, "firstTouch.a");
    requireReach(wayA, "firstTouch.wayA");
    requireReach(b, "firstTouch.b");
    requireReach(wayB, "firstTouch.wayB");
    requirePositive(tolerance, "firstTouch.tolerance");
    if (!hasPieces(a) && !hasPieces(b)) return touchOf(a, wayA, b, wayB, tolerance, 1);
    // Of several pieces that overlap at the start the deepest.
    if (const std::optional<Overlap> deep = overlap(a, poseOn(wayA, 0), b, poseOn(wayB, 0)))
        return Touch{0, 0.5 * deep->pointA + 0.5 * deep->pointB, deep->normal};
    std::optional<Touch> first;
    const std::vector<Shape> piecesB = piecesOf(b);
    std::vector<Aabb> boxesB;
    for (const Shape& pieceB : piecesB) boxesB.push_back(sweptBox(pieceB, wayB));
    for (const Shape& pieceA : piecesOf(a)) {
        const Aabb boxA = inflate(sweptBox(pieceA, wayA), tolerance);
        for (std::size_t i = 0; i < piecesB.size(); ++i) {
            if (!overlap(boxA, boxesB[i])) continue;
            const auto touch = touchOf(pieceA, wayA, piecesB[i], wayB, tolerance, first ? first->time : 1);
            if (touch && (!first || touch->time < first->time)) first = touch;
        }
    }
    return first;
}

Transform poseOn(const Way& way, double time) {
    const Rot rotation = Rot::fromAngle(way.angle + way.turn * time);
    return {way.start + way.shift * time - rotation * way.localCenter, rotation};
}

std::optional<double> timeWithin(const SweptShape& a, const SweptShape& b, double limit, double from) {
    const Vec2 shift = b.way.shift - a.way.shift;
    const Vec2 between = b.way.start - a.way.start;
    const double farthest = std::max(between.norm(), (between + shift).norm());
    const double turning = std::fabs(b.way.turn - a.way.turn) * b.reach;
    const double bend = std::fabs(a.way.turn) * (2 * shift.norm() + std::fabs(a.way.turn) * farthest);
    double time = from;
    for (int i = 0; i < mostAdvances; ++i) {
        const Distance now = distance(*a.shape, poseOn(a.way, time), *b.shape, poseOn(b.way, time));
        const double room = now.separation - limit;
        if (room <= early) return time;
        const Vec2 apart = between + shift * time;
        const double closing = (perp(apart) * a.way.turn - shift).dot(now.normal) + turning;
        const double fastest = closing + std::sqrt(closing * closing + 2 * bend * room);
        if (!(fastest * (1 - time) > 2 * room)) return std::nullopt;
        time += 2 * room / fastest;
    }
    return time;
}

}  // namespace plumb
