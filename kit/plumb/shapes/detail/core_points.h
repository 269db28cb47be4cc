// SPDX-License-Identifier: MIT
// Which points, and what radius around them, bound a shape?
#pragma once
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The shape lies in the convex hull of the points, enlarged by the radius, and touches all its sides.
struct CorePoints {
    std::vector<Vec2> points;  ///< in the body's frame [m]
    double radius = 0;         ///< [m]
};
CorePoints corePointsOf(const Shape& shape);

}  // namespace plumb
