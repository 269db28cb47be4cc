// SPDX-License-Identifier: MIT
// How thick is a shape, and how far does turning take it?
#pragma once
#include <plumb/math/vec2.h>
#include <plumb/shapes/shape.h>

namespace plumb {

/// Radius of a disc that fits into the shape: moved by less, it has not gone through anything [m].
double inradiusOf(const Shape& shape);

/// Farthest point that turning about center moves along a normal: of what is rounded, of the core within [m].
double turningRadiusOf(const Shape& shape, const Vec2& center);

}  // namespace plumb
