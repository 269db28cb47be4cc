// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_curve.h>

#include <algorithm>

#include <plumb/math/trig.h>

namespace plumb {

bool isStop(RowState state) {
    return state == RowState::AtLowerStop || state == RowState::AtUpperStop;
}

double slopeOf(const JointRow& row, double w) {
    // A larger value removes all of the speed; a smaller one removes nothing, and its inverse would be too large.
    constexpr double least = 1e-16, most = 30;
    return row.damper * w > least ? exponentialMinus1(std::min(row.damper * w, most)) / w : 0.0;
}

void dropDrive(JointRow& row) {
    if (row.holds) return;
    row.push = row.damper = row.low = row.high = 0;
    row.bounded = false;
}

void dampAhead(JointRow& row, double w, double speed) {
    if (row.bounded || !(row.damper > 0) || !(w > 0)) return;
    row.dampPush = exponentialMinus1(-row.damper * w) / w * speed;
    row.push += row.dampPush;
    row.damper = 0;
}

RowEquation equationOf(const JointRow& row, RowState state, double w) {
    if (row.holds) return {false, 0, row.target, relativeCompliance * w};
    if (isStop(state))
        return {false, 0, state == RowState::AtLowerStop ? row.lowerStop : row.upperStop, relativeCompliance * w};
    const double slope = slopeOf(row, w);
    if (row.bounded) {
        if (state == RowState::AtTarget && slope > 0) return {false, 0, row.push / slope, 1 / slope};
        return {true, state == RowState::AtTarget ? std::clamp(row.push, row.low, row.high)
                      : state == RowState::AtHigh ? row.high
                                                  : row.low};
    }
    if (state == RowState::AtTarget) return {false, 0, row.target, relativeCompliance * w};
    const double impulse = row.push + (state == RowState::AtHigh ? row.high : row.low);
    if (slope > 0) return {false, 0, impulse / slope, 1 / slope};
    return {true, impulse};
}

RowState nextState(const JointRow& row, RowState state, double speed, double total, double w) {
    if (row.holds) return RowState::AtTarget;
    const double aside = row.push - slopeOf(row, w) * speed;
    if (row.bounded)
        return aside > row.high ? RowState::AtHigh : aside < row.low ? RowState::AtLow : RowState::AtTarget;
    const double impulse = total - aside;
    const bool driven = row.high > row.low;
    switch (state) {
        case RowState::AtTarget:
            if (impulse > row.high) return RowState::AtHigh;
            return impulse < row.low ? RowState::AtLow : state;
        case RowState::AtHigh:
        case RowState::AtLow:
            if (speed < row.lowerStop) return RowState::AtLowerStop;
            if (speed > row.upperStop) return RowState::AtUpperStop;
            return driven && (speed > row.target) == (state == RowState::AtHigh) && speed != row.target
                       ? RowState::AtTarget
                       : state;
        case RowState::AtLowerStop: return impulse < row.high ? RowState::AtHigh : state;
        case RowState::AtUpperStop: return impulse > row.low ? RowState::AtLow : state;
    }
    return state;
}

RowState validState(const JointRow& row, RowState state) {
    if (!(row.high < unlimited)) return RowState::AtTarget;  // a row that holds without a bound
    if (state == RowState::AtLowerStop && !(row.lowerStop > -unlimited)) return RowState::AtHigh;
    if (state == RowState::AtUpperStop && !(row.upperStop < unlimited)) return RowState::AtLow;
    if (state == RowState::AtTarget && !row.bounded && !(row.high > row.low)) return RowState::AtLow;
    return row.bounded && isStop(state) ? RowState::AtTarget : state;
}

}  // namespace plumb
