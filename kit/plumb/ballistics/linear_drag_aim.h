// SPDX-License-Identifier: MIT
// How must a shot be aimed with wind and with drag proportional to its speed relative to the air?
#pragma once
#include <vector>

#include <plumb/ballistics/linear_drag.h>

namespace plumb {

struct LinearDragAim {
    Vec2 target{0, 0};  ///< from the muzzle [m]
    double speed = 0;   ///< when it leaves the muzzle, in the world's frame, >= 0 [m/s]
    LinearDrag drag{};
};

/// None, one or two shots, the earlier first.
///   |d - a m(t)| = v r(t),  u = (d - a m) / r,  a = g + k W
/// d target [m], v speed, u velocity [m/s], t time [s], g gravity, k rate, W wind as in LinearDrag, r and m the gain
/// and reach of dragStep(k, t) in kinematics/linear_drag.h. All shots of that speed are on a circle at any time. r is a
/// concave function of m, so the left side minus the right is convex in m: there are at most two zeros, and Newton's
/// method converges to each from outside without overshooting. Two zeros that rounding cannot separate count as one. A
/// target at the muzzle is hit at once, by one shot straight up. Shots whose time would not be finite are left out.
/// Throws std::invalid_argument on input out of range (shot.h). Test: "a million shots of fixed speed through linear
/// drag hit, and where there is none no angle does"
std::vector<Shot> aimThroughLinearDrag(const LinearDragAim& problem);

struct LinearDragTimeAim {
    Vec2 target{0, 0};  ///< from the muzzle [m]
    double time = 1;    ///< to the target, > 0 [s]
    LinearDrag drag{};
};

/// The shot that reaches the target after this time: u = (d - a m) / r. Throws as above.
/// Test: "a million shots of fixed time through linear drag are at their target then"
Shot aimThroughLinearDragInTime(const LinearDragTimeAim& problem);

}  // namespace plumb
