// SPDX-License-Identifier: MIT
// How does a body slide along an axis of another, without turning relative to it?
//
// Three rows: one keeps B's anchor on the axis, one keeps B's angle; the third acts along the axis, for a motor, a
// limit and a spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class PrismaticJoint {
public:
    AnchorPair anchors;

    PrismaticJoint(const PrismaticJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
          def_(def),
          localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())),
          reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

    const PrismaticJointDef& def() const { return def_; }
    void set(const PrismaticJointDef& def) { def_ = def; }
    JointForm form() const {
        JointForm form(anchors);
        form.measured = {.axis = RowAxis::OnA, .direction = localAxis_};
        form.add(RowAxis::OnA, perp(localAxis_));
        form.add(RowAxis::Turning).origin = reference_;
        if (def_.maxMotorForce == 0 && !def_.limit && !def_.spring) return form;
        RowForm& sliding = form.addFree(RowAxis::OnA, localAxis_);
        sliding.speed = def_.motorSpeed;
        sliding.maxForce = def_.maxMotorForce;
        if (def_.limit) sliding.limit = *def_.limit;
        if (def_.spring) sliding.spring = *def_.spring;
        sliding.springRest = def_.restShift;
        return form;
    }

private:
    PrismaticJointDef def_;
    Vec2 localAxis_{1, 0};  ///< unit, in A's frame
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
