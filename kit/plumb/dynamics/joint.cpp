// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint.h>

#include <plumb/dynamics/detail/joints_edit.h>
#include <plumb/dynamics/detail/validate.h>

namespace plumb {

JointDef JointView::def() const {
    return world_->joints[index_].def();
}

JointReaction JointView::reaction() const {
    const JointLoad& load = world_->joints.loads[index_];
    return {load.force(), load.torque()};
}

JointCoordinate JointView::coordinate() const {
    return {world_->joints.coordinateOf(index_, world_->bodies), world_->joints.speedOf(index_, world_->bodies)};
}

double JointView::error() const {
    return world_->joints.errorOf(index_, world_->bodies);
}

double JointView::angleError() const {
    return world_->joints.angleErrorOf(index_, world_->bodies);
}

void Joint::set(const JointDef& def) {
    validateChange(*world_, world_->joints[index_].def(), def);
    changeJoint(*world_, index_, def);
}

}  // namespace plumb
