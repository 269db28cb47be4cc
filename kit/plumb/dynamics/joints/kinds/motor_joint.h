// SPDX-License-Identifier: MIT
// How is a body moved against another with bounded force?
//
// Three rows, each driven: along the way that B is to go, across it, and turning.
#pragma once
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class MotorJoint {
public:
    AnchorPair anchors;

    MotorJoint(const MotorJointDef& def, const BodyStore& bodies);

    const MotorJointDef& def() const { return def_; }
    void set(const MotorJointDef& def);
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    double coordinate(const Ends& ends) const { return off(ends).norm(); }
    JointRow coordinateRow(const Ends& ends) const;
    static double error(const Ends&) { return 0; }  ///< it may be off, as far as its force goes

private:
    Vec2 off(const Ends& ends) const { return ends.b.point - (ends.a.point + ends.a.rotation * offset_); }

    MotorJointDef def_;
    Vec2 startOffset_{0, 0};
    double startAngle_ = 0;
    Vec2 offset_{0, 0};  ///< of B's origin from A's, in A's frame [m]
    double angle_ = 0;   ///< of B against A [rad]
};

}  // namespace plumb
