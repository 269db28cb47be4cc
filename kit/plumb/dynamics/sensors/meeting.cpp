// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/meeting.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/shape_radii.h>

namespace plumb {

namespace {

/// An upper bound on how far the two shapes have moved relative to each other [m].
double travelOf(const Sweep& sensor, const Sweep& visitor, const Shape& shape) {
    const Vec2 apart = visitor.start - sensor.start, shift = visitor.shift - sensor.shift;
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
    std::vector<PathPiece> there = paths.of(visitor.owner);
    const std::vector<PathPiece> here = paths.of(sensor.owner);
    for (PathPiece& piece : there) piece.way.start += pair.shift;
    if (here.size() == 1 && there.size() == 1 && travelOf(here.front().way, there.front().way, shape) < separation)
        return false;
    const double radius = turningRadiusOf(shape, there.front().way.localCenter);
    for (const PathPiece& a : here)
        for (const PathPiece& b : there) {
            const double start = std::max(a.start, b.start), end = std::min(a.end, b.end);
            if (start > end) continue;
            const SweptShape swept{&shape, partBetween(b, start, end), radius};
            if (timeOfApproach({&sensor.def.shape, partBetween(a, start, end), 0}, swept, 0, 0)) return true;
        }
    return false;
}

}  // namespace plumb
