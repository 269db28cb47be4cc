// SPDX-License-Identifier: MIT
// How do two bodies hang on one rope over two fixed wheels?
//
// One row: the rate of lengthA + ratio lengthB. This sum may not exceed the length of the rope; the joint pulls and
// never pushes.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class PulleyJoint {
public:
    AnchorPair anchors;

    PulleyJoint(const PulleyJointDef& def, const BodyStore& bodies);

    const PulleyJointDef& def() const { return def_; }
    void set(const PulleyJointDef& def);
    JointForm form() const;

private:
    PulleyJointDef def_;
    double startA_ = 0, startB_ = 0;  ///< lengths when it was made [m]
    double length_ = 0;               ///< of the rope, B's part counted ratio times [m]
};

}  // namespace plumb
