// SPDX-License-Identifier: MIT
// Which convex polygon holds these points?
#pragma once
#include <span>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The convex hull: corners are points that came in, counter-clockwise, from the leftmost (of those the lowest) on.
/// Points that repeat, lie in line, or stick out by less than a polygon's tolerances are left out, so that the result
/// is a polygon that a body can have; what is left out lies outside of it by no more than 5e-6 of the whole.
/// Throws std::invalid_argument if a point is not finite, fewer than 3 corners remain, or more than maxPolygonVertices.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
/// Test: "hulls of 10,000 clouds of points are what brute force finds"
Polygon hullOf(std::span<const Vec2> points);

}  // namespace plumb
