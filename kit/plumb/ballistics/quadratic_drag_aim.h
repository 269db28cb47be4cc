// SPDX-License-Identifier: MIT
// How must a shot be aimed whose drag grows as the square of its speed?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct QuadraticDragAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double speed = 0;        ///< on leaving the muzzle, >= 0 [m/s]
    double coefficient = 0;  ///< drag over mass and speed squared, rho C A / (2 m), >= 0 [1/m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// None, one or two shots in still air: the low arc first, then the high one.
///   u'' = g - c |u| u
/// u velocity [m/s], g gravity [m/s^2], c coefficient [1/m]. The path is integrated over its slope (Bernoulli's
/// hodograph, 1719), so that it takes a few dozen points of Gauss's; a launch is judged by where it crosses the
/// straight line to the target. One over the distance of that point is a convex function of the launch's slope, so
/// Newton's method comes to either shot from outside: from the low arc of the greater gravity that drag amounts to
/// on a flat path, and from the high arc without drag. Convex is what 100,000 paths were; it is not proven.
/// Targets straight above and below have closed forms, as has everything without drag or without gravity; at a speed of
/// 0 only what is straight below is hit, by a fall through drag.
/// A target within 1e-11 of the greatest reach counts as there. A target at the muzzle is hit at once, by one shot
/// straight up. What would take no finite time is left out. Error of place below 1e-9 of the path.
/// Throws std::invalid_argument on input out of range (shot.h).
/// Tests: "a million shots through quadratic drag hit, and where there is none no angle does", "a stone dropped from
/// rest falls as slowly through drag as one thrown at next to nothing"
std::vector<Shot> aimThroughQuadraticDrag(const QuadraticDragAim& problem);

}  // namespace plumb
