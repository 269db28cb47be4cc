// SPDX-License-Identifier: MIT
// What is one motion of a closed form, and where is its body at time t?
#pragma once
#include <compare/scene/closed_form.h>
#include <compare/scene/state.h>
#include <plumb/dynamics/body_def.h>

namespace plumb::compare {

struct WorkedMotion {
    BodyMotion motion{};  ///< with its numbers
    double until = 0;     ///< it holds until this time; 0: to the scene's end [s]
};

/// The state of a body of a definition at t >= 0 [s]; all numbers are NaN before the first flight. The motion must hold
/// its numbers itself: if its numbers must first be computed from the scene, all numbers are NaN.
BodyState motionState(const BodyMotion& motion, const BodyDef& def, double t);

/// A state in which all numbers are NaN.
BodyState unknownState();

}  // namespace plumb::compare
