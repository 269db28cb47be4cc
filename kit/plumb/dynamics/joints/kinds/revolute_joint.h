// SPDX-License-Identifier: MIT
// How do two bodies share a point and turn about it?
//
// Three rows: two keep the gap between the anchors along x and y at 0; the third turns B relative to A, for a motor, a
// limit and a spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

class RevoluteJoint {
public:
    AnchorPair anchors;

    RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies);

    const RevoluteJointDef& def() const { return def_; }
    void set(const RevoluteJointDef& def) { def_ = def; }
    void addRows(JointRows& rows, const Ends& now, const JointPass& pass) const;
    JointForm form() const;
    /// A single row: the coordinate that a gear connects.
    JointForm coordinateForm() const;
    SpringLoad springLoad(const Ends& now) const;
    double coordinate(const Ends& ends) const { return ends.angle() - reference_; }
    static JointRow coordinateRow(const Ends&) { return rowTurning(); }
    double error(const Ends& ends) const;
    double angleError(const Ends& ends) const;  ///< beyond its limit
    /// Without motor, limit and spring.
    bool isPlain() const { return def_.maxMotorTorque == 0 && !def_.limit && !def_.spring; }

private:
    RevoluteJointDef def_;
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
