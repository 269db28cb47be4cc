// SPDX-License-Identifier: MIT
// How does a wheel turn on a car, and move up and down on its suspension?
//
// Three rows: the first keeps the hub on the axis; the second turns the wheel, for a motor; the third acts along the
// axis, for a limit and the suspension's spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class WheelJoint {
public:
    AnchorPair anchors;

    WheelJoint(const WheelJointDef& def, const BodyStore& bodies);

    const WheelJointDef& def() const { return def_; }
    void set(const WheelJointDef& def) { def_ = def; }
    JointForm form() const;

private:
    WheelJointDef def_;
    Vec2 localAxis_{0, 1};  ///< unit, in A's frame
};

}  // namespace plumb
