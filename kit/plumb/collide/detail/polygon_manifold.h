// SPDX-License-Identifier: MIT
// Where do two polygons touch, rounded or not? A segment is a polygon of two edges.
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold_point.h>

namespace plumb {

/// Two cores of two or more points each, in one frame; magnitude: size of b's coordinates before they were made
/// relative, for the rounding error [m].
Manifold polygonManifold(const Core& a, const Core& b, float magnitude, float margin);

/// The same with this edge of a as the reference edge; none if no part of b is above or below it.
Manifold edgeManifold(const Core& a, std::size_t edge, const Core& b, float magnitude, float margin);

}  // namespace plumb
