// SPDX-License-Identifier: MIT
// What holds bodies together? The part of World that handles joints, and the view of one joint.
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/jointed/island_solver.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>

namespace plumb {

JointId World::join(const JointDef& def) {
    validate(*state_, def);
    const JointIndex joint = addJoint(*state_, def, islandSolver());
    return {joint, state_->joints[joint].generation, state_->bodies.world};
}

void World::remove(JointId id) {
    requireJoint(*state_, id, "JointId");
    removeJoint(*state_, id.index);
}

bool World::contains(JointId id) const {
    return isKnown(*state_, id);
}

Joint World::joint(JointId id) {
    requireJoint(*state_, id, "JointId");
    return {*state_, id};
}

JointView World::joint(JointId id) const {
    requireJoint(*state_, id, "JointId");
    return {*state_, id};
}

std::vector<JointId> World::joints() const {
    std::vector<JointId> ids;
    const std::vector<JointRecord>& records = state_->joints.records;
    for (JointIndex joint = 0; joint < records.size(); ++joint)
        if (!records[joint].isFree() && !records[joint].isHidden())
            ids.push_back({joint, records[joint].generation, state_->bodies.world});
    return ids;
}

std::span<const JointBroke> World::jointBreaks() const {
    return state_->events.breaks;
}

JointId JointView::id() const {
    return id_;
}

std::uint32_t JointView::index() const {
    requireJoint(*world_, id_, "JointId");
    return id_.index;
}

JointDef JointView::def() const {
    return world_->joints[index()].def();
}

JointReaction JointView::reaction() const {
    const JointLoad& load = world_->joints.loads[index()];
    return {load.force(), load.torque()};
}

JointCoordinate JointView::coordinate() const {
    return {world_->joints.coordinateOf(index(), world_->bodies), world_->joints.speedOf(index(), world_->bodies)};
}

double JointView::error() const {
    return world_->joints.errorOf(index(), world_->bodies);
}

double JointView::angleError() const {
    return world_->joints.angleErrorOf(index(), world_->bodies);
}

void Joint::set(const JointDef& def) {
    validateChange(world_->joints[index()].def(), def);
    changeJoint(*world_, index(), def);
}

/// For each kind of joint that has a motor; which ones do is asked of their definitions, so no list has to be kept.
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
    validateChange(def(), changed);
    requireMotor(changed);
    changeJoint(*world_, index(), changed);
}

}  // namespace plumb
