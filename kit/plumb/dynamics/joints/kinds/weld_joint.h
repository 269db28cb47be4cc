// SPDX-License-Identifier: MIT
// How are two bodies held together as one?
//
// Three rows, for the gap along x and y and for the angle. A row with a spring is elastic instead of held.
#pragma once
#include <cmath>

#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class WeldJoint {
public:
    AnchorPair anchors;

    WeldJoint(const WeldJointDef& def, const BodyStore& bodies);

    const WeldJointDef& def() const { return def_; }
    void set(const WeldJointDef& def) { def_ = def; }
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    SpringLoad springLoad(const Ends& now) const;
    double coordinate(const Ends& ends) const { return ends.angle() - reference_; }
    static JointRow coordinateRow(const Ends&) { return rowTurning(); }
    double angleError(const Ends& ends) const { return def_.bending ? 0.0 : std::fabs(coordinate(ends)); }
    double error(const Ends& ends) const { return def_.spring ? 0.0 : ends.apart().norm(); }

private:
    WeldJointDef def_;
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
