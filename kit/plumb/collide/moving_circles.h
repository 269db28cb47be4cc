// SPDX-License-Identifier: MIT
// When do two circles that move in a straight line touch? The lecture's swept capsule, in closed form.
#pragma once
#include <optional>

#include <plumb/collide/sweep.h>

namespace plumb {

struct MovingCircle {
    double radius = 0.5;  ///< >= 0 [m]
    Vec2 position{0, 0};  ///< of the centre, at time 0 [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// The first touch from time 0 on; empty when they never touch. It is within a step if its time is no later than the
/// end of the step. Circles that overlap at the start touch at time 0, even if they separate.
///   t = c / (b + sqrt(R^2 v^2 - (p x v)^2)), c = |p|^2 - R^2, b = -p . v
/// p, v position and velocity of B relative to A [m, m/s], R sum of the radii [m], t time [s]
/// Source: |p + v t| = R, by the root that does not cancel; differences of squares as products. The same as a ray
/// against a circle of radius R, and as the capsule that a circle sweeps (slide 26). Exact to rounding.
/// Throws std::invalid_argument on a number that is not finite or above 1e75 (fourth powers would overflow), and on a
/// negative radius.
/// Test: "a circle of 1 m at 10 m/s touches one of 1 m at (8, 1) after .6267949192 s"
std::optional<Touch> firstTouch(const MovingCircle& a, const MovingCircle& b);

}  // namespace plumb
