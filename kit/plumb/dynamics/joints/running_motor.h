// SPDX-License-Identifier: MIT
// Does a joint's motor run?
#pragma once
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Does something that should move at a speed follow it? It does at half of that speed, and at enough.
inline bool follows(double speed, double wanted, double enough) {
    const double along = wanted < 0 ? -speed : speed;
    return wanted != 0 && along > std::min(0.5 * std::fabs(wanted), enough);
}

/// Has the joint a motor with a target speed, and does it move its body that way? It does not if something stops it.
/// enough: the speed at which it runs, even if it is slow for its target [m/s or rad/s].
bool isMotorRunning(const JointStore& joints, const BodyStore& bodies, JointIndex joint, double enough);

}  // namespace plumb
