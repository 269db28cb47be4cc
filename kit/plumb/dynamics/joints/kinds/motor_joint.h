// SPDX-License-Identifier: MIT
// How is a body moved relative to another with bounded force?
//
// Three driven rows: along the missing velocity of B, across it, and turning.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class MotorJoint {
public:
    AnchorPair anchors;

    MotorJoint(const MotorJointDef& def, const BodyStore& bodies);

    const MotorJointDef& def() const { return def_; }
    void set(const MotorJointDef& def);
    JointForm form() const;

private:
    MotorJointDef def_;
    Vec2 startOffset_{0, 0};
    double startAngle_ = 0;
    Vec2 offset_{0, 0};  ///< of B's origin from A's, in A's frame [m]
    double angle_ = 0;   ///< of B against A [rad]
};

}  // namespace plumb
