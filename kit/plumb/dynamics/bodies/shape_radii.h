// SPDX-License-Identifier: MIT
// How thick is a shape, and how far can a rotation move its points?
#pragma once
#include <plumb/math/vec2.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Radius of a disc that fits into the shape; 0 for lines and tile maps. A shape that moves by less than this cannot
/// have passed through anything [m].
double inradiusOf(const Shape& shape);

/// The largest distance from center of a point that a rotation about center can move along a contact normal [m]. The
/// rounding radius does not count: only corners, end points or a circle's centre do.
double turningRadiusOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
