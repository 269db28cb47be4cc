// SPDX-License-Identifier: MIT
// Where do two polygons touch, rounded or not? A segment is a polygon of two edges.
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold.h>

namespace plumb {

/// Two cores of two or more points each, in one frame; b's numbers came from as far as this [m], and are as rough.
Manifold polygonManifold(const Core& a, const Core& b, float far, float margin);

/// The same, where only that edge of a may lend its normal; none if b does not reach above or below it.
Manifold edgeManifold(const Core& a, std::size_t edge, const Core& b, float far, float margin);

}  // namespace plumb
