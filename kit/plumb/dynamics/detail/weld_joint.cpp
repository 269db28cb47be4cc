// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/weld_joint.h>

namespace plumb {

WeldJoint::WeldJoint(const WeldJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

JointRows WeldJoint::rows(const Ends& now, const JointPass& pass) const {
    const Ends later = after(now, pass.step);
    JointRows rows = rowsFor(now);
    if (!def_.spring) holdPoint(rows, now, later, pass);
    if (!def_.bending) holdRow(rows, rowTurning(), {coordinate(now), coordinate(later)}, now, pass);
    return rows;
}

SpringRows WeldJoint::springs(const Ends& now) const {
    SpringRows springs = springsFor(now);
    if (def_.spring) addPointSpring(springs, now, *def_.spring);
    if (def_.bending) addSpring(springs, rowTurning(), coordinate(now), *def_.bending);
    return springs;
}

}  // namespace plumb
