// SPDX-License-Identifier: MIT
// How must a shot be aimed with drag proportional to the square of its speed?
#pragma once
#include <vector>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct QuadraticDragAim {
    Vec2 target{0, 0};       ///< from the muzzle [m]
    double speed = 0;        ///< when it leaves the muzzle, >= 0 [m/s]
    double coefficient = 0;  ///< drag over (mass times speed squared), rho C A / (2 m), >= 0 [1/m]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// None, one or two shots in still air: the low arc first, then the high one.
///   u'' = g - c |u| u
/// u velocity [m/s], g gravity [m/s^2], c coefficient [1/m]. The trajectory is integrated over its slope (Bernoulli's
/// hodograph, 1719), which takes a few dozen points of Gauss quadrature. A launch is evaluated by where it crosses the
/// straight line to the target. The reciprocal of the distance of that point is a convex function of the launch slope,
/// so Newton's method converges to either shot from outside: from the low arc with the larger gravity that drag is
/// equivalent to on a flat trajectory, and from the high arc without drag. It was convex for 100,000 trajectories; this
/// is not proven.
/// Targets straight above and below have closed forms, as has everything without drag or without gravity; at a speed of
/// 0 only a target straight below is hit, by a fall with drag.
/// A target within 1e-11 of the greatest reach counts as reached. A target at the muzzle is hit at once, by one shot
/// straight up. Shots whose time would not be finite are left out. Position error below 1e-9 of the trajectory's
/// length.
/// Throws std::invalid_argument on input out of range (shot.h).
/// Tests: "a million shots through quadratic drag hit, and where there is none no angle does", "a stone dropped from
/// rest falls as slowly through drag as one thrown at next to nothing"
std::vector<Shot> aimThroughQuadraticDrag(const QuadraticDragAim& problem);

}  // namespace plumb
