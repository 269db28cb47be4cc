// SPDX-License-Identifier: MIT
// On which part of its curve is a row (see joint_rows.h), and what does it want there?
#pragma once
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

/// e: give of a row, as a share of what its own impulse does to it [-]. Rows that say the same share their load, and
/// what their numbers disagree by is not multiplied by more than its inverse.
inline constexpr double rowGive = 1e-5;

/// A row on a part of its curve: v + give L = speed, or, if there is no such thing, L = impulse.
struct RowEquation {
    bool known = false;
    double impulse = 0;
    double speed = 0, compliance = 0;
};

// w is what a unit impulse does to the row's speed.
bool isStop(RowState state);
/// d of a damper.
double slopeOf(const JointRow& row, double w);
/// All but what it holds, and where it stops.
void dropDrive(JointRow& row);
/// Before a sub-step, a damper goes by the speed there was.
void dampAhead(JointRow& row, double w, double speed);
RowEquation equationOf(const JointRow& row, RowState state, double w);
/// The part of the curve next to the one on which speed and impulse are no answer.
RowState nextState(const JointRow& row, RowState state, double speed, double total, double w);
/// A state from another step may name a stop, or a bound of force, that is not there now.
RowState validState(const JointRow& row, RowState state);

}  // namespace plumb
