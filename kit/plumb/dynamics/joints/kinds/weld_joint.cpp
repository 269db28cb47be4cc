// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/weld_joint.h>

namespace plumb {

WeldJoint::WeldJoint(const WeldJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

JointForm WeldJoint::form() const {
    JointForm form(anchors);
    form.measured = {.axis = RowAxis::Turning, .origin = reference_};
    if (!def_.spring) form.holdPoint();
    for (const int axis : {0, 1})
        if (def_.spring) form.addFree(RowAxis::World, Vec2::Unit(axis)).spring = *def_.spring;
    if (def_.bending) {
        RowForm& turning = form.addFree(RowAxis::Turning);
        turning.origin = reference_;
        turning.spring = *def_.bending;
    } else {
        form.add(RowAxis::Turning).origin = reference_;
    }
    return form;
}

}  // namespace plumb
