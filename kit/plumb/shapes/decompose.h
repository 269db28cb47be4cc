// SPDX-License-Identifier: MIT
// Which convex polygons make up an outline?
#pragma once
#include <span>
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// Convex polygons that cover a simple outline, and nothing beside it, without overlapping: the corners of each are
/// points of the outline, and each is one that a body can have. No more than four times as many as the fewest
/// possible, but for what the limit of corners adds, and mostly far less.
/// The outline may run either way round. Points that repeat the one before, or lie in line with those beside them, by
/// less than a polygon's tolerances (see shape.h), are left out.
/// Throws std::invalid_argument if a point is not finite, fewer than 3 corners remain, the outline folds back on,
/// crosses or touches itself, or a part of it is too thin for any polygon.
/// Source: Hertel and Mehlhorn, "Fast triangulation of simple polygons", 1983: triangles, and then every diagonal is
/// taken out that is not needed to keep both of its ends convex.
/// Test: "pieces of 8,000 random outlines cover them, and nothing else, without overlapping"
std::vector<Polygon> convexPieces(std::span<const Vec2> outline);

}  // namespace plumb
