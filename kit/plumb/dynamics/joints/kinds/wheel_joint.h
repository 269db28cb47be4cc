// SPDX-License-Identifier: MIT
// How does a wheel turn on a car, and move up and down on its suspension?
//
// Three rows: the first keeps the hub on the axis; the second turns the wheel, for a motor; the third acts along the
// axis, for a limit and the suspension's spring.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class WheelJoint {
public:
    AnchorPair anchors;

    WheelJoint(const WheelJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
          def_(def),
          localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())) {}

    const WheelJointDef& def() const { return def_; }
    void set(const WheelJointDef& def) { def_ = def; }
    JointForm form() const {
        JointForm form(anchors);
        form.measured = {.axis = RowAxis::OnA, .direction = localAxis_};
        form.add(RowAxis::OnA, perp(localAxis_));
        if (def_.maxMotorTorque > 0) {
            RowForm& turning = form.addFree(RowAxis::Turning);
            turning.speed = def_.motorSpeed;
            turning.maxForce = def_.maxMotorTorque;
        }
        if (!def_.limit && !def_.spring) return form;
        RowForm& sliding = form.addFree(RowAxis::OnA, localAxis_);
        if (def_.limit) sliding.limit = *def_.limit;
        if (def_.spring) sliding.spring = *def_.spring;
        sliding.springRest = def_.restShift;
        return form;
    }

private:
    WheelJointDef def_;
    Vec2 localAxis_{0, 1};  ///< unit, in A's frame
};

}  // namespace plumb
