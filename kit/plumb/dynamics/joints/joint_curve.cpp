// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_curve.h>

#include <algorithm>

#include <plumb/math/trig.h>

namespace plumb {

double slopeOf(const JointRow& row, double w) {
    // A larger value removes all of the speed; a smaller one removes nothing, and its inverse would be too large.
    constexpr double least = 1e-16, most = 30;
    return row.damper * w > least ? exponentialMinus1(std::min(row.damper * w, most)) / w : 0.0;
}

}  // namespace plumb
