// SPDX-License-Identifier: MIT
// Where do two polygons touch, rounded or not? A segment is a polygon of two edges.
#pragma once
#include <plumb/collide/manifold.h>

namespace plumb {

/// Two cores of two or more points each, in one frame; b's numbers came from as far as this [m], and are as rough.
Manifold polygonManifold(const Convex& a, const Convex& b, float far, float margin);

}  // namespace plumb
