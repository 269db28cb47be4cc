// SPDX-License-Identifier: MIT
// How does a body slide along an axis of another, without turning relative to it?
//
// Three rows: one keeps B's anchor on the axis, one keeps B's angle; the third acts along the axis, for a motor, a
// limit and a spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class PrismaticJoint {
public:
    AnchorPair anchors;

    PrismaticJoint(const PrismaticJointDef& def, const BodyStore& bodies);

    const PrismaticJointDef& def() const { return def_; }
    void set(const PrismaticJointDef& def) { def_ = def; }
    JointForm form() const;

private:
    PrismaticJointDef def_;
    Vec2 localAxis_{1, 0};  ///< unit, in A's frame
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
