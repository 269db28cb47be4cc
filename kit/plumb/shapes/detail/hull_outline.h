// SPDX-License-Identifier: MIT
// Which of these points are corners of their convex hull?
#pragma once
#include <span>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

using HullIndices = std::vector<std::size_t>;

/// Counter-clockwise, starting with the leftmost point (the lowest of several); no corner is collinear with its
/// neighbours. Collinear points have two corners; so have several equal points, and one point has one. There must be
/// one point or more, and all must be finite.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
HullIndices hullOutline(std::span<const Vec2> points);

}  // namespace plumb
