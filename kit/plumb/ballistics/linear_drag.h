// SPDX-License-Identifier: MIT
// How does a shot fly whose drag is proportional to its speed relative to the air?
#pragma once
#include <optional>

#include <plumb/ballistics/shot.h>

namespace plumb {

struct LinearDrag {
    double rate = 0;         ///< drag over (mass times speed), >= 0 [1/s]
    Vec2 wind{0, 0};         ///< velocity of the air [m/s]
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
};

/// The highest point; empty when the shot does not rise, or is not pulled back.
///   t = ln(1 + k w / b) / k
/// t time [s], k rate [1/s], w upward velocity at the launch [m/s], b downward component of g + k W, the acceleration
/// of a shot at rest [m/s^2], g gravity [m/s^2], W wind [m/s]. For the position at other times use moveWithDrag({{0,
/// 0}, velocity}, {rate, wind, gravity}, time) of kinematics/linear_drag.h.
/// Throws std::invalid_argument on input out of range (shot.h). Source: x'' = g - k (x' - W).
/// Test: "apex and landing through linear drag are where 100,000 flights turn and touch the ground"
std::optional<PathPoint> linearDragApex(const Vec2& velocity, const LinearDrag& drag);

/// Where the shot lands on horizontal ground at a height below the muzzle; empty when it never does. At the muzzle's
/// own height and without vertical wind
///   t = (q + W0(-q e^-q)) / k,  q = 1 + k w / |g|
/// W0 Lambert's function. Here it is found by Newton's method on the height, which is a convex or concave function of
/// time, so that the method converges to its last zero from one side. Throws as above.
std::optional<PathPoint> linearDragLanding(const Vec2& velocity, double height, const LinearDrag& drag);

}  // namespace plumb
