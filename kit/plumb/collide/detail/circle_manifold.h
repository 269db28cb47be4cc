// SPDX-License-Identifier: MIT
// Where does a circle touch a circle, or a polygon?
#pragma once
#include <plumb/collide/detail/core.h>
#include <plumb/collide/manifold.h>

namespace plumb {

struct Disc {
    Vec2f center{0, 0};  ///< [m]
    float radius = 0;    ///< [m]
};

Manifold circleManifold(const Disc& a, const Disc& b, float margin);

/// A core of two or more points against a circle in its frame, whose centre came from as far as this [m].
Manifold circleManifold(const Core& a, const Disc& b, float far, float margin);

}  // namespace plumb
