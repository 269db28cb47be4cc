// SPDX-License-Identifier: MIT
// How are two bodies held together as one?
//
// Three rows, for the gap along x and y and for the angle. A row with a spring is elastic instead of held.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class WeldJoint {
public:
    AnchorPair anchors;

    WeldJoint(const WeldJointDef& def, const BodyStore& bodies);

    const WeldJointDef& def() const { return def_; }
    void set(const WeldJointDef& def) { def_ = def; }
    JointForm form() const;

private:
    WeldJointDef def_;
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
