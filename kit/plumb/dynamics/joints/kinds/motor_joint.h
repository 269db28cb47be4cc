// SPDX-License-Identifier: MIT
// How is a body moved relative to another with bounded force?
//
// Three driven rows: along the missing velocity of B, across it, and turning.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class MotorJoint {
public:
    AnchorPair anchors;

    MotorJoint(const MotorJointDef& def, const BodyStore& bodies);

    const MotorJointDef& def() const { return def_; }
    void set(const MotorJointDef& def);
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    double coordinate(const Ends& ends) const { return off(ends).norm(); }
    JointRow coordinateRow(const Ends& ends) const;
    static double error(const Ends&) { return 0; }  ///< no error: its force is bounded, so B may stay off its target

private:
    Vec2 off(const Ends& ends) const { return ends.b.point - (ends.a.point + ends.a.rotation * offset_); }

    MotorJointDef def_;
    Vec2 startOffset_{0, 0};
    double startAngle_ = 0;
    Vec2 offset_{0, 0};  ///< of B's origin from A's, in A's frame [m]
    double angle_ = 0;   ///< of B against A [rad]
};

}  // namespace plumb
