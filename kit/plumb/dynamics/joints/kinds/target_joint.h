// SPDX-License-Identifier: MIT
// How is a point of a body dragged to a point of the world?
//
// Two rows, along the line to the target and across it: a spring of bounded force between the two points.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class TargetJoint {
public:
    AnchorPair anchors;

    TargetJoint(const TargetJointDef& def, const BodyStore& bodies);

    const TargetJointDef& def() const { return def_; }
    void set(const TargetJointDef& def, const BodyStore& bodies);
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    SpringLoad springLoad(const Ends& now) const;
    static double coordinate(const Ends& ends) { return ends.apart().norm(); }
    static JointRow coordinateRow(const Ends& ends) { return rowAlong(ends.apart().stableNormalized(), ends); }
    static double error(const Ends&) { return 0; }

private:
    /// Unit vectors along the line to the target, and across it.
    static std::array<Vec2, 2> axes(const Ends& ends);

    TargetJointDef def_;
    Spring spring_;
};

}  // namespace plumb
