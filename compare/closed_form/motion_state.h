// SPDX-License-Identifier: MIT
// Where is the body of one motion of a closed form at time t?
#pragma once
#include <compare/scene/state.h>

namespace plumb::compare {

/// The state of a body of a definition at t >= 0 [s]; all numbers are NaN before the first flight. The motion must hold
/// its numbers itself: if its numbers must first be computed from the scene, all numbers are NaN.
BodyState motionState(const BodyMotion& motion, const BodyDef& def, double t);

/// A state in which all numbers are NaN.
BodyState unknownState();

}  // namespace plumb::compare
