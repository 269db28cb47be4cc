// SPDX-License-Identifier: MIT
// What happened in the last step?
#pragma once
#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// A shape of one body and a shape of another began to touch, or hit each other anew.
struct ContactBegin {
    BodyId bodyA, bodyB;
    Vec2 point{0, 0};          ///< where, in the world [m]
    Vec2 normal{0, 1};         ///< from A to B [-]
    double approachSpeed = 0;  ///< at which the points came together along the normal, >= 0 [m/s]
};

/// A shape of one body and a shape of another ceased to touch, also because one was removed before the step. An id may
/// be of a body that was removed.
struct ContactEnd {
    BodyId bodyA, bodyB;
};

/// A body left the range of finite numbers. It was put back to where it was before, and stays there, disabled.
struct Quarantined {
    BodyId body;
};

}  // namespace plumb
