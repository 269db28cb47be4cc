// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/prismatic_joint.h>

#include <algorithm>
#include <cmath>

namespace plumb {

PrismaticJoint::PrismaticJoint(const PrismaticJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())),
      reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

void PrismaticJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    holdRow(rows, rowAlong(perp(axis(now)), now), {aside(now), aside(later)}, now, pass);
    holdRow(rows, rowTurning(), {turned(now), turned(later)}, now, pass);
    if (def_.maxMotorForce == 0 && !def_.limit && !def_.spring) return;
    JointRow& sliding = rows.add() = coordinateRow(now);
    drive(sliding, def_.motorSpeed, def_.maxMotorForce, pass);
    const PredictedCoordinate predicted{coordinate(now), coordinate(later)};
    if (def_.limit) keepWithin(sliding, *def_.limit, predicted, speedAhead(sliding, now, pass.step), pass);
    if (def_.spring) pull(sliding, *def_.spring, predicted.now - def_.restShift, pass);
}

SpringLoad PrismaticJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    if (def_.spring) addLoad(load, coordinateRow(now), *def_.spring, coordinate(now) - def_.restShift, true);
    return load;
}

double PrismaticJoint::error(const Ends& ends) const {
    const double shift = coordinate(ends);
    const double beyond = def_.limit ? std::max({0.0, def_.limit->lower - shift, shift - def_.limit->upper}) : 0.0;
    return std::max(std::fabs(aside(ends)), beyond);
}

JointForm PrismaticJoint::form() const {
    JointForm form(anchors);
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

JointForm PrismaticJoint::coordinateForm() const {
    JointForm form(anchors);
    form.add(RowAxis::OnA, localAxis_);
    return form;
}

}  // namespace plumb
