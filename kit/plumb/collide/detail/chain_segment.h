// SPDX-License-Identifier: MIT
// Which convex shapes are segments of a chain?
#pragma once
#include <plumb/collide/convex.h>

namespace plumb {

inline bool isVector(const Vec2f& v) {
    return v.x() != 0 || v.y() != 0;
}

/// Is this a segment with a neighbour?
inline bool isChainSegment(const Convex& shape) {
    return shape.count == 2 && (isVector(shape.before) || isVector(shape.after) || shape.oneSided);
}

}  // namespace plumb
