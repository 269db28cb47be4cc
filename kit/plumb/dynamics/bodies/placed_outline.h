// SPDX-License-Identifier: MIT
// Which corners and which rounding radius describe a shape in the world?
#pragma once
#include <vector>

#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/shapes/shape.h>

namespace plumb {

struct PlacedOutline {
    std::vector<Vec2> corners;  ///< in the world [m]
    double radius = 0;          ///< rounding radius: the outline lies this far outside the corners [m]
    bool hasArea = false;
};

/// The outline of a shape on a body that is in the state `there`.
PlacedOutline placedOutline(const Shape& shape, const BodyRecord& body, const BodyMotion& there);

}  // namespace plumb
