// SPDX-License-Identifier: MIT
// Which two bodies do not touch each other?
#pragma once
#include <plumb/dynamics/joint_def.h>

namespace plumb {

/// Only keeps its bodies from touching.
class FilterJoint {
public:
    explicit FilterJoint(const FilterJointDef& def) : def_(def) {}
    const FilterJointDef& def() const { return def_; }
    void set(const FilterJointDef& def) { def_ = def; }

private:
    FilterJointDef def_;
};

}  // namespace plumb
