// SPDX-License-Identifier: MIT
// How steep is the damper's part of a row's curve (see joint_rows.h)?
#pragma once
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

/// e: compliance of a row, relative to the row's effective inverse mass [-]. Redundant rows (rows with the same
/// constraint) then share their load, and a difference between their right sides is amplified by at most 1 / e.
inline constexpr double relativeCompliance = 1e-5;

/// The slope d of a damper. w: the row's effective inverse mass, the change of its speed by a unit impulse.
double slopeOf(const JointRow& row, double w);

}  // namespace plumb
