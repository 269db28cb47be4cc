// SPDX-License-Identifier: MIT
// How does a body slide along an axis of another, without turning relative to it?
//
// Three rows: one keeps B's anchor on the axis, one keeps B's angle; the third acts along the axis, for a motor, a
// limit and a spring.
#pragma once
#include <cmath>

#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class PrismaticJoint {
public:
    AnchorPair anchors;

    PrismaticJoint(const PrismaticJointDef& def, const BodyStore& bodies);

    const PrismaticJointDef& def() const { return def_; }
    void set(const PrismaticJointDef& def) { def_ = def; }
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    /// A single row: the coordinate that a gear connects.
    JointForm coordinateForm() const;
    SpringLoad springLoad(const Ends& now) const;
    double coordinate(const Ends& ends) const { return axis(ends).dot(ends.apart()); }
    JointRow coordinateRow(const Ends& ends) const { return rowAlong(axis(ends), ends); }
    double error(const Ends& ends) const;
    double angleError(const Ends& ends) const { return std::fabs(turned(ends)); }

private:
    Vec2 axis(const Ends& ends) const { return ends.a.rotation * localAxis_; }
    double aside(const Ends& ends) const { return perp(axis(ends)).dot(ends.apart()); }
    double turned(const Ends& ends) const { return ends.angle() - reference_; }

    PrismaticJointDef def_;
    Vec2 localAxis_{1, 0};  ///< unit, in A's frame
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
