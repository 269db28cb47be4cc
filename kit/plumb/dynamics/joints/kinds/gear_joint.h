// SPDX-License-Identifier: MIT
// How does one joint drive another?
//
// One row: the rate of a + ratio b, a and b the coordinates of two joints, so up to four bodies feel it.
#pragma once
#include <plumb/dynamics/joints/joint_rows.h>

namespace plumb {

/// One of the two joints, as it stands.
struct Geared {
    std::array<BodyIndex, 2> body{};
    JointRow row;  ///< of its coordinate
    PredictedCoordinate predicted;
    double speed = 0;  ///< [m/s or rad/s]
};

class GearJoint {
public:
    /// at: the joints' slots and their coordinates now.
    GearJoint(const GearJointDef& def, double a, double b)
        : jointA(def.jointA.index), jointB(def.jointB.index), def_(def), total_(a + def.ratio * b) {}

    std::uint32_t jointA = 0, jointB = 0;

    const GearJointDef& def() const { return def_; }
    void set(const GearJointDef& def, double a, double b) {
        def_ = def;
        total_ = a + def.ratio * b;
    }
    double ratio() const { return def_.ratio; }
    double total() const { return total_; }
    void addRows(JointRows& rows, const Geared& a, const Geared& b, const JointPass& pass) const;

private:
    GearJointDef def_;
    double total_ = 0;  ///< what a + ratio b is to stay [m or rad]
};

}  // namespace plumb
