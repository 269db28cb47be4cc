// SPDX-License-Identifier: MIT
// The intervals of a box along the axes, whichever of its corners is the lower one.
#pragma once
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Inverted boxes overlap boxes that extend across them: boxes that overlap also do so when their corners are ordered.
inline Aabb ordered(const Aabb& box) {
    return {box.lower.cwiseMin(box.upper), box.lower.cwiseMax(box.upper)};
}

/// A box with such a coordinate overlaps nothing.
inline bool hasNaN(const Aabb& box) {
    return box.lower.hasNaN() || box.upper.hasNaN();
}

}  // namespace plumb
