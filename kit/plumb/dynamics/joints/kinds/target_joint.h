// SPDX-License-Identifier: MIT
// How is a point of a body dragged to a point of the world?
//
// Two rows, along the line to the target and across it: a spring of bounded force between the two points.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class TargetJoint {
public:
    AnchorPair anchors;

    TargetJoint(const TargetJointDef& def, const BodyStore& bodies);

    const TargetJointDef& def() const { return def_; }
    void set(const TargetJointDef& def, const BodyStore& bodies);
    JointForm form() const;

private:
    TargetJointDef def_;
    Spring spring_;
};

}  // namespace plumb
