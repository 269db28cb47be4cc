// SPDX-License-Identifier: MIT
// How is dragStep() computed for input that has been checked?
#pragma once
#include <plumb/kinematics/linear_drag.h>

namespace plumb::detail {

/// dragStep() without its checks: for a time that is infinite or NaN, so is the result.
DragStep uncheckedDragStep(double rate, double time);

}  // namespace plumb::detail
