// SPDX-License-Identifier: MIT
// How wide is the face of a shape in one direction?
#pragma once
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb::detail {

/// The interval along a line of those corners of a shape's core that are farthest in one direction, to 1 mm; a single
/// value for a round shape, and for a face that is not perpendicular to the direction.
struct FaceSpan {
    double low = 0, high = 0;  ///< [m]
    double farthest = 0;       ///< in that direction, with the shape's radius [m]
};

FaceSpan faceSpan(const Shape& shape, const Transform& pose, const Vec2& direction, const Vec2& line);

}  // namespace plumb::detail
