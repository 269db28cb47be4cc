// SPDX-License-Identifier: MIT
// Which way does an outline push that is solid on its left, where a cast met one of its segments?
#pragma once
#include <optional>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The outward normal for a cast that met a segment by itself with this normal, in the segment's frame [-]. Along the
/// segment and at a joint that is flat or hollow that is the segment's own; at a corner, any between its own and its
/// neighbour's. None where it was met from behind, or through the neighbour at a narrow hollow, or where the neighbour
/// is what was met.
/// Test: "10,000 movers slide over flush tiles, floor and wall, as on one slab, and lose nothing"
std::optional<Vec2> outlineNormal(const Segment& segment, const Vec2& normal);

}  // namespace plumb
