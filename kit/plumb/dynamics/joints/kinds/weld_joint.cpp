// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/weld_joint.h>

namespace plumb {

WeldJoint::WeldJoint(const WeldJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

void WeldJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    if (!def_.spring) holdPoint(rows, now, later, pass);
    for (const int axis : {0, 1})
        if (def_.spring) pull(rows.add() = rowAlong(Vec2::Unit(axis), now), *def_.spring, now.apart()[axis], pass);
    if (def_.bending)
        pull(rows.add() = rowTurning(), *def_.bending, coordinate(now), pass);
    else
        holdRow(rows, rowTurning(), {coordinate(now), coordinate(later)}, now, pass);
}

SpringLoad WeldJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    for (const int axis : {0, 1})
        if (def_.spring) addLoad(load, rowAlong(Vec2::Unit(axis), now), *def_.spring, now.apart()[axis], !def_.bending);
    if (def_.bending) addLoad(load, rowTurning(), *def_.bending, coordinate(now));
    return load;
}

JointForm WeldJoint::form() const {
    JointForm form(anchors);
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
