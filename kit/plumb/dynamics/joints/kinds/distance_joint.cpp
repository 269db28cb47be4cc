// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/distance_joint.h>

namespace plumb {

DistanceJoint::DistanceJoint(const DistanceJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchorA, bodies),
              anchorAt(def.bodyB.index, bodies.near(def.anchorB, def.anchorA), bodies)},
      def_(def),
      apart_((bodies.near(def.anchorB, def.anchorA) - def.anchorA).norm()),
      length_(def.length.value_or(apart_)) {}

void DistanceJoint::set(const DistanceJointDef& def) {
    def_ = def;
    length_ = def.length.value_or(apart_);
}

JointForm DistanceJoint::form() const {
    JointForm form(anchors);
    form.measured = {.axis = RowAxis::Along};
    if (!def_.spring) {
        form.add(RowAxis::Along).origin = length_;
        return form;
    }
    RowForm& stretching = form.addFree(RowAxis::Along);
    stretching.speed = def_.motorSpeed;
    stretching.maxForce = def_.maxMotorForce;
    if (def_.minLength > 0 || def_.maxLength < unlimited) stretching.limit = {def_.minLength, def_.maxLength};
    stretching.spring = *def_.spring;
    stretching.springRest = length_;
    return form;
}

}  // namespace plumb
