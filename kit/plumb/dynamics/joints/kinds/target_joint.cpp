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

std::array<Vec2, 2> TargetJoint::axes(const Ends& ends) {
    const Vec2 way = ends.apart();
    const Vec2 along = way.squaredNorm() > 0 ? Vec2(way.stableNormalized()) : Vec2(1, 0);
    return {along, perp(along)};
}

void TargetJoint::addRows(JointRows& rows, const Ends& now, const JointPass& pass) const {
    for (const Vec2& axis : axes(now)) {
        JointRow& row = rows.add() = rowAlong(axis, now);
        pull(row, spring_, axis.dot(now.apart()), pass);
        row.bounded = boundOf(def_.maxForce) < unlimited;
        if (row.bounded) row.high = def_.maxForce * (0.5 * pass.step);
        row.low = -row.high;
    }
}

SpringLoad TargetJoint::springLoad(const Ends& now) const {
    SpringLoad load;
    for (const Vec2& axis : axes(now)) addLoad(load, rowAlong(axis, now), spring_, axis.dot(now.apart()));
    load.mostForce = def_.maxForce;
    return load;
}

JointForm TargetJoint::form() const {
    JointForm form(anchors);
    for (const RowAxis axis : {RowAxis::Towards, RowAxis::Across}) {
        RowForm& row = form.addFree(axis);
        row.spring = spring_;
        row.bounded = boundOf(def_.maxForce) < unlimited;
        if (row.bounded) row.maxForce = def_.maxForce;
    }
    return form;
}

}  // namespace plumb
