// SPDX-License-Identifier: MIT
// How does a point slide without friction along the path of a disc's centre over a chain? Computed apart from the kit:
// the path is a polyline, and each of its vertices keeps a share of the speed.
#pragma once
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb::test {

struct TrackPath {
    std::vector<Vec2> points;
    std::vector<double> keeps;  ///< share of the speed that a vertex keeps: cos(turn) if it is concave, else 1 [-]
};

/// The path of a disc of this radius [m] on the left of a polyline. Arcs become 4 lines each, without loss.
TrackPath pathOver(const std::vector<Vec2>& line, double radius);

/// Where is the point, and how fast?
struct TrackPoint {
    std::size_t edge = 0;
    double way = 0;    ///< from the edge's start [m]
    double speed = 0;  ///< positive forwards [m/s]
};

Vec2 placeOn(const TrackPath& path, const TrackPoint& point);
/// The point on the path that is nearest to a place, at rest.
TrackPoint restNear(const TrackPath& path, const Vec2& place);
/// After a time [s] under gravity [m/s^2]; stops at the path's ends.
TrackPoint slide(const TrackPath& path, TrackPoint from, double gravity, double time);

}  // namespace plumb::test
