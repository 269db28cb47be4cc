// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint.h>

#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>

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
    validateChange(world_->joints[index_].def(), def);
    changeJoint(*world_, index_, def);
}

void Joint::setMotorSpeed(double speed) {
    JointDef changed = def();
    std::visit(
        [&]<class Def>(Def& d) {
            if constexpr (requires { d.motorSpeed; })
                d.motorSpeed = speed;
            else
                refuse("Joint.setMotorSpeed",
                       "a " + nameOf(changed) +
                           " has no motorSpeed; revolute, prismatic, distance and wheel joints have one");
        },
        changed);
    set(changed);
}

}  // namespace plumb
