// SPDX-License-Identifier: MIT
// How is a point of a body dragged to a point of the world?
//
// No rows: a spring from the one to the other, of bounded force.
#pragma once
#include <plumb/dynamics/detail/joint_rows.h>

namespace plumb {

class TargetJoint {
public:
    AnchorPair anchors;

    TargetJoint(const TargetJointDef& def, const BodyStore& bodies);

    void set(const TargetJointDef& def, const BodyStore& bodies);
    static JointRows rows(const Ends& now, const JointPass&) { return rowsFor(now); }
    SpringRows springs(const Ends& now) const;
    static double coordinate(const Ends& ends) { return ends.apart().norm(); }
    static JointRow coordinateRow(const Ends& ends) { return rowAlong(ends.apart().stableNormalized(), ends); }
    static double error(const Ends&) { return 0; }

private:
    TargetJointDef def_;
    Spring spring_;
};

}  // namespace plumb
