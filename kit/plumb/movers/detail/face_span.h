// SPDX-License-Identifier: MIT
// How broad is what a shape shows to one side?
#pragma once
#include <span>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

namespace plumb::detail {

/// Between which two lengths along a line the corners of a shape's core lie that are farthest out one way, to 1 mm; of
/// a round one, and of a face that is not flush, the two are one.
struct FaceSpan {
    double low = 0, high = 0;  ///< [m]
    double farthest = 0;       ///< along the way, with the shape's radius [m]
};

FaceSpan faceSpan(const Shape& shape, const Transform& pose, const Vec2& way, const Vec2& line);

}  // namespace plumb::detail
