// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/wheel_joint.h>

namespace plumb {

WheelJoint::WheelJoint(const WheelJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())) {}

JointForm WheelJoint::form() const {
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

}  // namespace plumb
