// SPDX-License-Identifier: MIT
// How do two bodies share a point and turn about it?
//
// Three rows: two keep the gap between the anchors along x and y at 0; the third turns B relative to A, for a motor, a
// limit and a spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class RevoluteJoint {
public:
    AnchorPair anchors;

    RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
          def_(def),
          reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

    const RevoluteJointDef& def() const { return def_; }
    void set(const RevoluteJointDef& def) { def_ = def; }
    JointForm form() const {
        JointForm form(anchors);
        form.holdPoint();
        form.measured = {.axis = RowAxis::Turning, .origin = reference_};
        if (isPlain()) return form;
        RowForm& turning = form.addFree(RowAxis::Turning);
        turning.origin = reference_;
        turning.speed = def_.motorSpeed;
        turning.maxForce = def_.maxMotorTorque;
        if (def_.limit) turning.limit = *def_.limit;
        if (def_.spring) turning.spring = *def_.spring;
        turning.springRest = def_.restAngle;
        return form;
    }
    /// Without motor, limit and spring.
    bool isPlain() const { return def_.maxMotorTorque == 0 && !def_.limit && !def_.spring; }

private:
    RevoluteJointDef def_;
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
