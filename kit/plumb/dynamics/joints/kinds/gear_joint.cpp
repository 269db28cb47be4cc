// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/kinds/gear_joint.h>

namespace plumb {

JointForm GearJoint::form(const JointForm& a, const JointForm& b) const {
    JointForm form = a.ofCoordinate();
    form.links = 2;
    form.link[1] = b.link[0];
    form.secondAxis = b.measured.axis;
    form.secondDirection = b.measured.direction;
    form.ratio = def_.ratio;
    form.measured.origin += def_.ratio * b.measured.origin;
    form.row[0].origin = form.measured.origin + total_;
    form.turnsOnly = true;
    return form;
}

}  // namespace plumb
