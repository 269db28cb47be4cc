// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/revolute_joint.h>

#include <algorithm>

namespace plumb {

RevoluteJoint::RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

void RevoluteJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    holdPoint(rows, now, later, pass);
    if (isPlain()) return;
    JointRow& turning = rows.add() = rowTurning();
    drive(turning, def_.motorSpeed, def_.maxMotorTorque, pass);
    const PredictedCoordinate predicted{coordinate(now), coordinate(later)};
    if (def_.limit) keepWithin(turning, *def_.limit, predicted, speedAhead(turning, now, pass.step), pass);
    if (def_.spring) pull(turning, *def_.spring, predicted.now - def_.restAngle, pass);
}

SpringLoad RevoluteJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    if (def_.spring) addLoad(load, rowTurning(), *def_.spring, coordinate(now) - def_.restAngle);
    return load;
}

double RevoluteJoint::error(const Ends& ends) const {
    return std::max(ends.apart().norm(), angleError(ends) * ends.b.arm.norm());
}

double RevoluteJoint::angleError(const Ends& ends) const {
    const double turned = coordinate(ends);
    return def_.limit ? std::max({0.0, def_.limit->lower - turned, turned - def_.limit->upper}) : 0.0;
}

JointForm RevoluteJoint::form() const {
    JointForm form(anchors);
    form.holdPoint();
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

JointForm RevoluteJoint::coordinateForm() const {
    JointForm form(anchors);
    form.add(RowAxis::Turning).origin = reference_;
    return form;
}

}  // namespace plumb
