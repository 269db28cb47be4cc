// SPDX-License-Identifier: MIT
// How must a shot be aimed whose drag grows as the square of its speed?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct QuadraticDragAim {
    Vec2 target{0, 0};       ///< from the muzzle, of up to 1e50 [m]
    double speed = 0;        ///< on leaving the muzzle, 0 to 1e50 [m/s]
    double coefficient = 0;  ///< drag over mass and speed squared, rho C A / (2 m), 0 to 1e50 [1/m]
    Vec2 gravity{0, -9.81};  ///< of up to 1e50 [m/s^2]
};

/// None, one or two shots in still air: the low arc first, then the high one.
std::vector<Shot> aimThroughQuadraticDrag(const QuadraticDragAim& problem);

}  // namespace plumb
