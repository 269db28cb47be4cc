// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/pulley_joint.h>

#include <algorithm>

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

double PulleyJoint::coordinate(const Ends& ends) const {
    return (ends.a.point - def_.groundA).norm() + def_.ratio * (ends.b.point - def_.groundB).norm();
}

JointRow PulleyJoint::coordinateRow(const Ends& ends) const {
    JointRow row;
    const Vec2 alongA = (ends.a.point - def_.groundA).stableNormalized();
    const Vec2 alongB = def_.ratio * (ends.b.point - def_.groundB).stableNormalized();
    row.at[0] = {alongA.x(), alongA.y(), cross(ends.a.arm, alongA)};
    row.at[1] = {alongB.x(), alongB.y(), cross(ends.b.arm, alongB)};
    return row;
}

void PulleyJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    JointRow& row = rows.add() = coordinateRow(now);
    keepWithin(row, {-unlimited, length_}, {coordinate(now), coordinate(later)}, speedAhead(row, now, pass.step), pass);
}

double PulleyJoint::error(const Ends& ends) const {
    return std::max(coordinate(ends) - length_, 0.0);
}

JointForm PulleyJoint::form() const {
    JointForm form({{def_.groundA, noBody, {0, 0}}, anchors.a});
    form.links = 2;
    form.link[1] = {{def_.groundB, noBody, {0, 0}}, anchors.b};
    form.secondAxis = RowAxis::Along;
    form.ratio = def_.ratio;
    form.addFree(RowAxis::Along).limit.upper = length_;
    return form;
}

}  // namespace plumb
