// SPDX-License-Identifier: MIT
// What is dragStep() of numbers that are known to be sound?
#pragma once
#include <plumb/kinematics/linear_drag.h>

namespace plumb::detail {

/// dragStep() without its checks: at a time that is infinite or NaN, so is what comes of it.
DragStep uncheckedDragStep(double rate, double time);

}  // namespace plumb::detail
