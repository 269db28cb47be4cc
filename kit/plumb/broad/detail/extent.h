// SPDX-License-Identifier: MIT
// From where to where does a box reach along each axis, whichever of its corners is called the lower one?
#pragma once
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Boxes turned inside out overlap what reaches across them: what overlaps has extents that do.
inline Aabb extentOf(const Aabb& box) {
    return {box.lower.cwiseMin(box.upper), box.lower.cwiseMax(box.upper)};
}

/// A box with such a coordinate overlaps nothing.
inline bool hasNaN(const Aabb& box) {
    return box.lower.hasNaN() || box.upper.hasNaN();
}

}  // namespace plumb
