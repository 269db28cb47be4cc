// SPDX-License-Identifier: MIT
// How far apart are two shapes, and where?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct Distance {
    double separation = 0;  ///< negative when they overlap: minus the depth along normal [m]
    Vec2 normal{0, 1};      ///< unit, from A to B
    Vec2 pointA{0, 0};      ///< nearest (or deepest) point of A, in the world [m]
    Vec2 pointB{0, 0};      ///< nearest (or deepest) point of B: pointA + separation normal, in the world [m]
};

}  // namespace plumb
