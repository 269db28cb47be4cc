// SPDX-License-Identifier: MIT
// In which direction does an outline that is solid on its left push, where a cast hit one of its segments?
#pragma once
#include <optional>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The outward normal for a cast that hit a segment on its own with this normal, in the segment's frame [-]. Along the
/// segment, and at a flat or concave vertex, that is the segment's own normal; at a convex corner, any normal between
/// its own and its neighbour's. None where the segment was hit from behind, or through the neighbour at a narrow
/// concave corner, or where the hit belongs to the neighbour.
/// Test: "10,000 movers slide over flush tiles, floor and wall, as on one slab, and lose nothing"
std::optional<Vec2> outlineNormal(const Segment& segment, const Vec2& normal);

}  // namespace plumb
