// SPDX-License-Identifier: MIT
// How thick is a shape, and how far can a rotation move its points?
#pragma once
#include <span>

#include <plumb/math/vec2.h>
#include <plumb/shapes/shape.h>
#include <plumb/space/shape_def.h>

namespace plumb {

/// Radius of a disc that fits into the shape; 0 for lines and tile maps. A shape that moves by less than this cannot
/// have passed through anything [m].
double inradiusOf(const Shape& shape);

/// Half the thickness of the thickest of some shapes, as the radius of the largest disc that fits into it. Lines and
/// sensors do not count; infinite when there are no others [m].
double halfThicknessOf(std::span<const ShapeDef> shapes);
/// A dynamic body needs a part of which half the thickness is this: contacts, which are soft and predicted a few
/// millimetres ahead, do not support thinner ones reliably [m]. Test: "whatever is as thick as 2 mm rests where it was
/// put, or falls, on any floor"
inline constexpr double leastHalfThickness = 1e-3;

/// The largest distance from center of a point that a rotation about center can move along a contact normal [m]. The
/// rounding radius does not count: only corners, end points or a circle's centre do.
double turningRadiusOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
