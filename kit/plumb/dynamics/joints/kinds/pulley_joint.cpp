// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/pulley_joint.h>

namespace plumb {

PulleyJoint::PulleyJoint(const PulleyJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, bodies.near(def.anchorA, def.groundA), bodies),
              anchorAt(def.bodyB.index, bodies.near(def.anchorB, def.groundB), bodies)},
      startA_((bodies.near(def.anchorA, def.groundA) - def.groundA).norm()),
      startB_((bodies.near(def.anchorB, def.groundB) - def.groundB).norm()) {
    set(def);
}

void PulleyJoint::set(const PulleyJointDef& def) {
    def_ = def;
    length_ = startA_ + def.ratio * startB_;
}

JointForm PulleyJoint::form() const {
    JointForm form({{def_.groundA, noBody, {0, 0}}, anchors.a});
    form.links = 2;
    form.link[1] = {{def_.groundB, noBody, {0, 0}}, anchors.b};
    form.secondAxis = RowAxis::Along;
    form.ratio = def_.ratio;
    form.measured = form.addFree(RowAxis::Along);
    form.row[0].limit.upper = length_;
    return form;
}

}  // namespace plumb
