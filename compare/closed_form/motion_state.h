// SPDX-License-Identifier: MIT
// Where does one motion of a closed form have its body at time t?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The state of a body of a definition at t >= 0 [s]; all numbers NaN before the first flight. The motion is one that
/// holds its numbers itself: of one that has to be worked out first all numbers are NaN.
BodyState motionState(const BodyMotion& motion, const BodyDef& def, double t);

/// All numbers NaN.
BodyState unknownState();

}  // namespace plumb::compare
