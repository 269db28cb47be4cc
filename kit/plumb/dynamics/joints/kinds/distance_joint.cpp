// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/distance_joint.h>

#include <algorithm>
#include <cmath>

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

JointRow DistanceJoint::coordinateRow(const Ends& ends) {
    JointRow row;
    const Vec2 along = ends.apart().stableNormalized();
    row.at[0] = {-along.x(), -along.y(), -cross(ends.a.arm, along)};
    row.at[1] = {along.x(), along.y(), cross(ends.b.arm, along)};
    return row;
}

void DistanceJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    const Ends later = ahead(now, pass);
    const double length = coordinate(now), then = coordinate(later);
    if (!def_.spring) {
        holdRow(rows, coordinateRow(now), {length - length_, then - length_}, now, pass);
        return;
    }
    JointRow& stretching = rows.add() = coordinateRow(now);
    drive(stretching, def_.motorSpeed, def_.maxMotorForce, pass);
    if (def_.minLength > 0 || def_.maxLength < unlimited)
        keepWithin(stretching, {def_.minLength, def_.maxLength}, {length, then}, speedAhead(stretching, now, pass.step),
                   pass);
    pull(stretching, *def_.spring, length - length_, pass);
}

SpringLoad DistanceJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    if (def_.spring) addLoad(load, coordinateRow(now), *def_.spring, coordinate(now) - length_);
    return load;
}

double DistanceJoint::error(const Ends& ends) const {
    const double length = coordinate(ends);
    if (!def_.spring) return std::fabs(length - length_);
    return std::max({0.0, def_.minLength - length, length - def_.maxLength});
}

JointForm DistanceJoint::form() const {
    JointForm form(anchors);
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
