// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/validate.h>
#include <plumb/dynamics/detail/world_state.h>
#include <plumb/dynamics/world.h>

namespace plumb {

JointId World::join(const JointDef& def) {
    validate(*state_, def);
    WorldState& world = *state_;
    std::uint32_t index = static_cast<std::uint32_t>(world.joints.size());
    if (world.freeJoints.empty()) {
        world.joints.emplace_back();
    } else {
        index = world.freeJoints.back();
        world.freeJoints.pop_back();
    }
    JointRecord& record = world.joints[index];
    std::visit(
        [&]<class Def>(const Def& d) {
            if constexpr (requires {
                              d.bodyA;
                              d.collideConnected;
                          }) {
                record.bodyA = d.bodyA.index;
                record.bodyB = d.bodyB.index;
                record.collideConnected = d.collideConnected;
            }
        },
        def);
    if (const auto* revolute = std::get_if<RevoluteJointDef>(&def))
        record.joint = RevoluteJoint(*revolute, world.bodies);
    else
        record.joint = DistanceJoint(std::get<DistanceJointDef>(def), world.bodies);
    world.jointsChanged = true;
    for (const BodyIndex body : {record.bodyA, record.bodyB}) {
        world.bodies.record[body].joints.push_back(index);
        wakeIsland(world, body);
    }
    if (!record.collideConnected) {
        forEachContact(world.bodies, world.contacts, record.bodyA, [&](ContactIndex c) {
            const ContactRecord& contact = world.contacts.contacts[c];
            if (contact.bodyA == record.bodyB || contact.bodyB == record.bodyB) removeContact(world, c);
        });
    }
    return {index, record.generation, world.id};
}

void World::remove(JointId id) {
    requireJoint(*state_, id, "JointId");
    WorldState& world = *state_;
    JointRecord& record = world.joints[id.index];
    for (const BodyIndex body : {record.bodyA, record.bodyB}) {
        wakeIsland(world, body);
        std::erase(world.bodies.record[body].joints, id.index);
    }
    world.jointsChanged = true;
    if (!record.collideConnected) pairShapes(world, record.bodyA, record.bodyB);
    const std::uint32_t generation = record.generation + 1;
    record = {};
    record.generation = generation;
    world.freeJoints.push_back(id.index);
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

}  // namespace plumb
