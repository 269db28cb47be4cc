// SPDX-License-Identifier: MIT
// How does a wheel turn on a car, and move up and down on its suspension?
//
// Three rows: the first keeps the hub on the axis; the second turns the wheel, for a motor; the third acts along the
// axis, for a limit and the suspension's spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class WheelJoint {
public:
    AnchorPair anchors;

    WheelJoint(const WheelJointDef& def, const BodyStore& bodies);

    const WheelJointDef& def() const { return def_; }
    void set(const WheelJointDef& def) { def_ = def; }
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    SpringLoad springLoad(const Ends& now) const;
    double coordinate(const Ends& ends) const { return axis(ends).dot(ends.apart()); }
    JointRow coordinateRow(const Ends& ends) const { return rowAlong(axis(ends), ends); }
    double error(const Ends& ends) const;

private:
    Vec2 axis(const Ends& ends) const { return ends.a.rotation * localAxis_; }
    double aside(const Ends& ends) const { return perp(axis(ends)).dot(ends.apart()); }

    WheelJointDef def_;
    Vec2 localAxis_{0, 1};  ///< unit, in A's frame
};

}  // namespace plumb
