// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/prismatic_joint.h>

namespace plumb {

PrismaticJoint::PrismaticJoint(const PrismaticJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

JointForm PrismaticJoint::form() const {
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

}  // namespace plumb
