// SPDX-License-Identifier: MIT
// Which points span the convex hull of a shape, or of a set of points?
#pragma once
#include <span>
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The shape lies in the convex hull of the points, enlarged by the radius, and touches all its sides.
struct CorePoints {
    std::vector<Vec2> points;  ///< in the body's frame [m]
    double radius = 0;         ///< [m]
};
CorePoints corePointsOf(const Shape& shape);

using HullIndices = std::vector<std::size_t>;

/// Which of these points are corners of their convex hull. Counter-clockwise, starting with the leftmost point (the
/// lowest of several); no corner is collinear with its neighbours. Collinear points have two corners; so have several
/// equal points, and one point has one. There must be one point or more, and all must be finite. Source: Andrew,
/// "Another efficient algorithm for convex hulls in two dimensions", 1979.
HullIndices hullOutline(std::span<const Vec2> points);

}  // namespace plumb
