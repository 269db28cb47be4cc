// SPDX-License-Identifier: MIT
// How does one joint drive another?
//
// One row: the rate of a + ratio b, a and b the coordinates of two joints, so it acts on up to four bodies.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class GearJoint {
public:
    /// a, b: the present coordinates of the two joints [m or rad].
    GearJoint(const GearJointDef& def, double a, double b)
        : jointA(def.jointA.index), jointB(def.jointB.index), def_(def), total_(a + def.ratio * b) {}

    std::uint32_t jointA = 0, jointB = 0;

    const GearJointDef& def() const { return def_; }
    void set(const GearJointDef& def, double a, double b) {
        def_ = def;
        total_ = a + def.ratio * b;
    }
    /// a, b: of the two joints.
    JointForm form(const JointForm& a, const JointForm& b) const {
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

private:
    GearJointDef def_;
    double total_ = 0;  ///< the constant value of a + ratio b [m or rad]
};

}  // namespace plumb
