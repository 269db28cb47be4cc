// SPDX-License-Identifier: MIT
// Into which convex polygons can an outline be decomposed?
#pragma once
#include <span>
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Convex polygons that cover a simple polygon exactly, without overlapping: their corners are points of the outline,
/// and each is valid for a body. At most four times as many as the minimum, apart from the limit on the number of
/// corners, and usually far fewer.
/// The outline may have either orientation. Points that repeat the one before, or are collinear with their neighbours,
/// within a polygon's tolerances (see shape.h), are left out.
/// Throws std::invalid_argument if a point is not finite, fewer than 3 corners remain, the outline folds back on,
/// crosses or touches itself, or a part of it is too thin for a valid polygon.
/// Source: Hertel and Mehlhorn, "Fast triangulation of simple polygons", 1983: triangulate, then remove every diagonal
/// that is not needed to keep both of its ends convex.
/// Test: "pieces of 8,000 random outlines cover them, and nothing else, without overlapping"
std::vector<Polygon> convexPieces(std::span<const Vec2> outline);

}  // namespace plumb
