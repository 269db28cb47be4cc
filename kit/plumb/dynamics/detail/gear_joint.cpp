// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/gear_joint.h>

namespace plumb {

JointRows GearJoint::rows(const Geared& a, const Geared& b, const JointPass& pass) const {
    JointRows rows;
    rows.count = 1;
    rows.ends = 4;
    // The second end is the one whose force is told: what the second joint moves.
    rows.body = {a.body[1], b.body[1], a.body[0], b.body[0]};
    JointRow& row = rows.row[0];
    row.at[0] = a.row.at[1];
    row.at[2] = a.row.at[0];
    for (std::size_t i = 0; i < 3; ++i) {
        row.at[1][i] = ratio_ * b.row.at[1][i];
        row.at[3][i] = ratio_ * b.row.at[0][i];
    }
    const Course course{a.course.now + ratio_ * b.course.now - total_,
                        a.course.later + ratio_ * b.course.later - total_};
    hold(row, course, a.speed + ratio_ * b.speed, pass);
    return rows;
}

}  // namespace plumb
