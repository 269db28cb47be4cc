// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/meeting.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/dynamics/bodies/shape_radii.h>

namespace plumb {

namespace {

/// An upper bound on how far the two shapes have moved relative to each other [m].
double travelOf(const Sweep& sensor, const Sweep& visitor, const Vec2& image, const Shape& shape) {
    const Vec2 apart = visitor.start + image - sensor.start, shift = visitor.shift - sensor.shift;
    const double reach = turningRadiusOf(shape, visitor.localCenter);
    return shift.norm() + std::fabs(visitor.turn) * reach +
           std::fabs(sensor.turn) * (apart.norm() + shift.norm() + reach);
}

/// The part of a piece of a path between two shares of the step.
Sweep partBetween(const PathPiece& piece, double start, double end) {
    const double whole = piece.end - piece.start;
    if (whole <= 0) return piece.way;
    return partOf(piece.way, (start - piece.start) / whole, (end - piece.start) / whole);
}

}  // namespace

bool haveMet(const SensorPair& pair, double separation, const Space& space, BodyPaths& paths) {
    const Proxy& sensor = space[pair.sensor];
    const Proxy& visitor = space[pair.visitor];
    const Shape& shape = visitor.def.shape;
    const auto meet = [&](const Sweep& here, Sweep there) {
        there.start += pair.shift;
        const SweptShape swept{&shape, there, turningRadiusOf(shape, there.localCenter)};
        return timeOfApproach({&sensor.def.shape, here, 0}, swept, 0, 0).has_value();
    };
    if (paths.isStraight(sensor.owner) && paths.isStraight(visitor.owner)) {
        const Sweep here = paths.chordOf(sensor.owner), there = paths.chordOf(visitor.owner);
        return travelOf(here, there, pair.shift, shape) >= separation && meet(here, there);
    }
    const std::vector<PathPiece> here = paths.of(sensor.owner), there = paths.of(visitor.owner);
    for (const PathPiece& a : here)
        for (const PathPiece& b : there) {
            const double start = std::max(a.start, b.start), end = std::min(a.end, b.end);
            if (start <= end && meet(partBetween(a, start, end), partBetween(b, start, end))) return true;
        }
    return false;
}

}  // namespace plumb
