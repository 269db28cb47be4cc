// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/body_paths.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <plumb/math/detail/sorting.h>
#include <plumb/math/trig.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// The bounds of a shape along a straight piece. A point's path differs from the straight line between its ends by at
/// most r turn^2 / 8, and by no more than two radii. r distance from the centre of mass [m], turn [rad]: the height of
/// an arc over its chord is r (1 - cos(turn / 2)).
Aabb boxAlong(const Shape& shape, const Sweep& sweep) {
    const double swing = turningRadiusOf(shape, sweep.localCenter) * std::min(0.125 * sweep.turn * sweep.turn, 2.0);
    return inflate(merge(aabbOf(shape, poseAt(sweep, 0)), aabbOf(shape, poseAt(sweep, 1))), swing);
}

}  // namespace

/// Trajectories are of all bodies, in the order of time: sorted by bodies at the first question, so that a step without
/// one costs nothing.
std::vector<PathPiece> BodyPaths::of(BodyIndex body) {
    std::vector<PathPiece> path;
    if (!isStraight(body)) {
        sortSegments();
        const auto isBefore = [this](std::uint32_t s, BodyIndex b) { return trajectories_[s].body < b; };
        auto at = std::lower_bound(sorted_.begin(), sorted_.end(), body, isBefore);
        for (; at != sorted_.end() && trajectories_[*at].body == body; ++at) {
            const TrajectorySegment& s = trajectories_[*at];
            const Sweep sweep{s.from.center, s.to.center - s.from.center, s.from.angle, s.to.angle - s.from.angle,
                              bodies_.record[body].localCenter};
            path.push_back({sweep, s.start / dt_, s.end / dt_});
        }
    }
    if (path.empty()) return {{chordOf(body), 0, 1}};
    if (path.back().end < 1) path.push_back({partOf(path.back().sweep, 1, 1), path.back().end, 1});  // it was stopped
    return path;
}

/// From the places in floats at the step's start: as exact as a float can be, but the turn only up to whole
/// revolutions, which aboutTurnOf adds.
Sweep BodyPaths::chordOf(BodyIndex body) const {
    const BodyPlace& place = bodies_.place[body];
    const BodyMotion& now = bodies_.motion[body];
    Sweep sweep;
    sweep.localCenter = bodies_.record[body].localCenter;
    sweep.start = {static_cast<double>(place.highX) + static_cast<double>(place.lowX),
                   static_cast<double>(place.highY) + static_cast<double>(place.lowY)};
    sweep.shift = now.center - sweep.start;
    const Vec2 before(static_cast<double>(place.cos), static_cast<double>(place.sin));
    const Vec2 after(now.rotation.cos, now.rotation.sin);
    sweep.turn = arcTangent(cross(before, after), before.dot(after));
    constexpr double revolution = 2 * std::numbers::pi;
    sweep.turn += revolution * std::round((aboutTurnOf(body) - sweep.turn) / revolution);
    // So that the sweep ends exactly at the present angle.
    sweep.angle = now.angle - sweep.turn;
    return sweep;
}

/// The turn in this step, with whole revolutions, but less exact than the rotations [rad].
double BodyPaths::aboutTurnOf(BodyIndex body) const {
    if (bodies_.isMovedBy(body, MovedBy::ClosedForm)) return bodies_.motion[body].angularVelocity * dt_;
    return bodies_.isMovedBy(body, MovedBy::Solver) ? static_cast<double>(bodies_.turn[body].angle) : 0;
}

Aabb BodyPaths::boxOf(BodyIndex body, const Shape& shape) {
    if (isStraight(body)) return boxAlong(shape, chordOf(body));
    const std::vector<PathPiece> path = of(body);
    Aabb box = boxAlong(shape, path.front().sweep);
    for (const PathPiece& piece : path) box = merge(box, boxAlong(shape, piece.sweep));
    return box;
}

void BodyPaths::sortSegments() {
    if (!sorted_.empty()) return;
    sorted_.resize(trajectories_.size());
    std::iota(sorted_.begin(), sorted_.end(), 0U);
    sortBy(sorted_, [this](std::uint32_t i) { return trajectories_[i].body; });
}

}  // namespace plumb
