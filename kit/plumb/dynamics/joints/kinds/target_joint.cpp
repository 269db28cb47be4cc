// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/target_joint.h>

namespace plumb {

TargetJoint::TargetJoint(const TargetJointDef& def, const BodyStore& bodies)
    : anchors{{}, anchorAt(def.body.index, def.anchor, bodies)} {
    set(def, bodies);
}

void TargetJoint::set(const TargetJointDef& def, const BodyStore& bodies) {
    def_ = def;
    anchors.a.local = bodies.near(def.target, endAtRest(anchors.b, bodies).point);
    spring_ = def.spring.value_or(springOf(5, 0.7, bodies.record[def.body.index].mass));
}

JointForm TargetJoint::form() const {
    JointForm form(anchors);
    form.measured = {.axis = RowAxis::Along};
    for (const RowAxis axis : {RowAxis::Towards, RowAxis::Across}) {
        RowForm& row = form.addFree(axis);
        row.spring = spring_;
        row.bounded = boundOf(def_.maxForce) < unlimited;
        if (row.bounded) row.maxForce = def_.maxForce;
    }
    return form;
}

}  // namespace plumb
