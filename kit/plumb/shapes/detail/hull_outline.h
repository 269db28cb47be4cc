// SPDX-License-Identifier: MIT
// Which of these points are corners of their convex hull?
#pragma once
#include <span>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

using HullIndices = std::vector<std::size_t>;

/// Counter-clockwise, from the leftmost (of those the lowest) on; none that lies in line between two others. Points in
/// line have two corners; so have several in one place, and one has one. There must be one, and all must be finite.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
HullIndices hullOutline(std::span<const Vec2> points);

}  // namespace plumb
