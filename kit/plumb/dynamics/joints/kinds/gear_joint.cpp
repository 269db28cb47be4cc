// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/gear_joint.h>

namespace plumb {

void GearJoint::addRows(JointRows& rows, const Geared& a, const Geared& b, const JointPass& pass) const {
    rows.ends = 4;
    // The second end is the one whose force is reported: body B of the second joint.
    rows.body = {a.body[1], b.body[1], a.body[0], b.body[0]};
    JointRow& row = rows.add();
    row.at[0] = a.row.at[1];
    rows.far[0] = a.row.at[0];
    for (std::size_t i = 0; i < 3; ++i) {
        row.at[1][i] = def_.ratio * b.row.at[1][i];
        rows.far[1][i] = def_.ratio * b.row.at[0][i];
    }
    const PredictedCoordinate predicted{a.predicted.now + def_.ratio * b.predicted.now - total_,
                                        a.predicted.later + def_.ratio * b.predicted.later - total_};
    hold(row, predicted, a.speed + def_.ratio * b.speed, pass);
}

JointForm GearJoint::form(const JointForm& a, const JointForm& b) const {
    JointForm form = a;
    form.links = 2;
    form.link[1] = b.link[0];
    form.secondAxis = b.row[0].axis;
    form.secondDirection = b.row[0].direction;
    form.ratio = def_.ratio;
    form.row[0].origin = a.row[0].origin + def_.ratio * b.row[0].origin + total_;
    form.turnsOnly = true;
    return form;
}

}  // namespace plumb
