// SPDX-License-Identifier: MIT
// How are two points kept at a distance, by a rod or by a spring?
//
// One row, along the line from anchor to anchor. For a rod it is held; for a spring it has limits and a motor.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class DistanceJoint {
public:
    AnchorPair anchors;

    DistanceJoint(const DistanceJointDef& def, const BodyStore& bodies);

    const DistanceJointDef& def() const { return def_; }
    void set(const DistanceJointDef& def);
    JointForm form() const;

private:
    DistanceJointDef def_;
    double apart_ = 1;  ///< distance of the anchors when the joint was made [m]
    double length_ = 1;
};

}  // namespace plumb
