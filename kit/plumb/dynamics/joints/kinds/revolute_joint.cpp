// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/revolute_joint.h>

namespace plumb {

RevoluteJoint::RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

JointForm RevoluteJoint::form() const {
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

}  // namespace plumb
