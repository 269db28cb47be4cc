// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/world.h>

namespace plumb {

JointId World::join(const JointDef& def) {
    validate(*state_, def);
    const JointIndex joint = addJoint(*state_, def);
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
    return {*state_, id.index};
}

JointView World::joint(JointId id) const {
    requireJoint(*state_, id, "JointId");
    return {*state_, id.index};
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

}  // namespace plumb
