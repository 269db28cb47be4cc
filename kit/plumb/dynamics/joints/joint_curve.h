// SPDX-License-Identifier: MIT
// On which part of its curve is a row (see joint_rows.h), and which equation holds there?
#pragma once
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

/// e: compliance of a row, relative to the row's effective inverse mass [-]. Redundant rows (rows with the same
/// constraint) then share their load, and a difference between their right sides is amplified by at most 1 / e.
inline constexpr double relativeCompliance = 1e-5;

/// The equation of a row on one part of its curve: v + compliance L = speed, or, where the impulse is known, L =
/// impulse.
struct RowEquation {
    bool known = false;
    double impulse = 0;
    double speed = 0, compliance = 0;
};

// In all functions, w is the row's effective inverse mass: the change of its speed by a unit impulse.
bool isStop(RowState state);
/// The slope d of a damper (see joint_rows.h).
double slopeOf(const JointRow& row, double w);
/// Removes the motor, spring and damper of a row. A row that holds, and the stops, stay.
void dropDrive(JointRow& row);
/// Before a sub-step, a damper acts by the speed at the start of that sub-step, as a known impulse.
void dampAhead(JointRow& row, double w, double speed);
RowEquation equationOf(const JointRow& row, RowState state, double w);
/// The next part of the curve, if speed and impulse are not a solution on the present one; else the same.
RowState nextState(const JointRow& row, RowState state, double speed, double total, double w);
/// Replaces a state from an earlier step that names a stop or a bound of force which the row no longer has.
RowState validState(const JointRow& row, RowState state);

}  // namespace plumb
