// SPDX-License-Identifier: MIT
// On which bodies does a joint act? On two, or up to four for a gear.
#pragma once
#include <algorithm>

#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// The bodies in the order of the rows' ends: noBody where there is none; one body may occur twice.
inline std::array<BodyIndex, maxEnds> endsOf(const JointStore& joints, JointIndex index) {
    const JointRecord& record = joints[index];
    const auto* gear = std::get_if<GearJoint>(&record.joint);
    if (gear == nullptr) return {record.bodyA, record.bodyB, noBody, noBody};
    return {record.bodyA, record.bodyB, joints[gear->jointA].bodyA, joints[gear->jointB].bodyA};
}

/// Calls visit(body) for each of them once.
template <class Visit>
void forEachBody(const JointStore& joints, JointIndex index, Visit&& visit) {
    const std::array<BodyIndex, maxEnds> ends = endsOf(joints, index);
    for (auto end = ends.begin(); end != ends.end(); ++end)
        if (*end != noBody && std::find(ends.begin(), end, *end) == end) visit(*end);
}

/// Does the joint have a body that it can move, and are all its bodies in the valid range of positions?
inline bool holdsSomething(const JointStore& joints, const BodyStore& bodies, JointIndex index) {
    const std::array<BodyIndex, maxEnds> ends = endsOf(joints, index);
    return std::any_of(ends.begin(), ends.end(), [&](BodyIndex body) { return bodies.canMove(body); }) &&
           std::all_of(ends.begin(), ends.end(), [&](BodyIndex body) { return isInRange(bodies.motion[body]); });
}

}  // namespace plumb
