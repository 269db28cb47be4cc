// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/wheel_joint.h>

#include <algorithm>
#include <cmath>

namespace plumb {

WheelJoint::WheelJoint(const WheelJointDef& def, const BodyStore& bodies)
    : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
      def_(def),
      localAxis_(bodies.motion[anchors.a.body].rotation.inverse() * Vec2(def.axis.stableNormalized())) {}

void WheelJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    holdRow(rows, rowAlong(perp(axis(now)), now), {aside(now), aside(later)}, now, pass);
    if (def_.maxMotorTorque > 0) {
        JointRow& turning = rows.add() = rowTurning();
        drive(turning, def_.motorSpeed, def_.maxMotorTorque, pass);
    }
    if (!def_.limit && !def_.spring) return;
    JointRow& sliding = rows.add() = coordinateRow(now);
    const PredictedCoordinate predicted{coordinate(now), coordinate(later)};
    if (def_.limit) keepWithin(sliding, *def_.limit, predicted, speedAhead(sliding, now, pass.step), pass);
    if (def_.spring) pull(sliding, *def_.spring, predicted.now - def_.restShift, pass);
}

SpringLoad WheelJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    if (def_.spring) addLoad(load, coordinateRow(now), *def_.spring, coordinate(now) - def_.restShift);
    return load;
}

double WheelJoint::error(const Ends& ends) const {
    const double shift = coordinate(ends);
    const double beyond = def_.limit ? std::max({0.0, def_.limit->lower - shift, shift - def_.limit->upper}) : 0.0;
    return std::max(std::fabs(aside(ends)), beyond);
}

JointForm WheelJoint::form() const {
    JointForm form(anchors);
    form.add(RowAxis::OnA, perp(localAxis_));
    if (def_.maxMotorTorque > 0) {
        RowForm& turning = form.addFree(RowAxis::Turning);
        turning.speed = def_.motorSpeed;
        turning.maxForce = def_.maxMotorTorque;
    }
    if (!def_.limit && !def_.spring) return form;
    RowForm& sliding = form.addFree(RowAxis::OnA, localAxis_);
    if (def_.limit) sliding.limit = *def_.limit;
    if (def_.spring) sliding.spring = *def_.spring;
    sliding.springRest = def_.restShift;
    return form;
}

}  // namespace plumb
