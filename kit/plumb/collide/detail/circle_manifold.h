// SPDX-License-Identifier: MIT
// Where does a circle touch a circle, or a polygon?
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold_point.h>
#include <plumb/math/vec2.h>

namespace plumb {

struct CoreDisc {
    Vec2f center{0, 0};  ///< [m]
    float radius = 0;    ///< [m]
};

Manifold circleManifold(const CoreDisc& a, const CoreDisc& b, float margin);

/// A core of two or more points against a circle in its frame; magnitude: size of the coordinates before they were made
/// relative [m].
Manifold circleManifold(const Core& a, const CoreDisc& b, float magnitude, float margin);

}  // namespace plumb
