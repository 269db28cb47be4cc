// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/islands.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/body_shapes.h>
#include <plumb/dynamics/detail/joint_bodies.h>
#include <plumb/dynamics/detail/load_bodies.h>
#include <plumb/dynamics/detail/pairs.h>

namespace plumb {

namespace {

BodyIndex otherOf(const ContactRecord& contact, BodyIndex body) {
    return contact.bodyA == body ? contact.bodyB : contact.bodyA;
}

/// Calls visit(other) for each dynamic body that touches or is joined to this one.
template <class Visit>
void forEachNeighbour(const WorldState& world, BodyIndex body, Visit&& visit) {
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const BodyIndex other = otherOf(contact, body);
        if (contact.touching && world.bodies.canMove(other)) visit(other);
    });
    for (const JointIndex joint : world.bodies.record[body].joints) {
        if (!world.joints[joint].acts()) continue;
        forEachBody(world.joints, joint, [&](BodyIndex other) {
            if (other != body && world.bodies.canMove(other)) visit(other);
        });
    }
}

void wakeOne(WorldState& world, BodyIndex body) {
    if (world.bodies.record[body].awake) {
        world.bodies.record[body].stillTime = 0;
        return;
    }
    world.bodies.wake(body);
    (void)loadBody(world, body, world.lastStep);
    world.bodies.record[body].boxesWait = true;  // a pair whose boxes part within a step, and meet again, would be lost
    world.jointsChanged = world.jointsChanged || !world.bodies.record[body].joints.empty();
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex c) { world.contacts.addNear(c); });
}

/// Does something that moves by itself press on the body?
bool drivenFromOutside(const WorldState& world, BodyIndex body) {
    bool driven = false;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const BodyRecord& other = world.bodies.record[otherOf(contact, body)];
        driven = driven || (contact.touching && other.type == BodyType::Kinematic && other.awake);
    });
    for (const JointIndex joint : world.bodies.record[body].joints) {
        forEachBody(world.joints, joint, [&](BodyIndex end) {
            driven = driven || (world.bodies.record[end].type == BodyType::Kinematic && world.bodies.record[end].awake);
        });
    }
    return driven;
}

bool isStill(const WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    const BodyMotion& motion = world.bodies.motion[body];
    double speed = motion.velocity.norm() + std::fabs(motion.angularVelocity) * record.extent;
    if (record.constrained) {  // what is being pushed or pulled into place has no velocity of its own, but it moves
        const SolverDisplacement& moved = world.bodies.displacement[body];
        speed =
            std::max(speed, std::hypot(static_cast<double>(moved.x), static_cast<double>(moved.y)) / world.lastStep);
    }
    // What nothing holds drifts on however slowly: only a body that is pushed upon may be stopped.
    return world.bodies.pushed[body] != 0 ? speed < world.def.solver.sleepSpeed && !drivenFromOutside(world, body)
                                          : speed == 0;
}

bool countStillness(WorldState& world, double dt) {
    bool anyReady = false;
    for (const BodyIndex body : world.bodies.awake) {
        BodyRecord& record = world.bodies.record[body];
        if (record.type != BodyType::Dynamic) continue;
        record.stillTime = record.canSleep && isStill(world, body) ? record.stillTime + dt : 0;
        anyReady = anyReady || record.stillTime >= world.def.solver.sleepTime;
    }
    return anyReady;
}

std::vector<BodyIndex> islandOf(const WorldState& world, BodyIndex seed, std::vector<bool>& seen) {
    std::vector<BodyIndex> island{seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < island.size(); ++i) {
        forEachNeighbour(world, island[i], [&](BodyIndex other) {
            if (seen[other]) return;
            seen[other] = true;
            island.push_back(other);
        });
    }
    return island;
}

void putToSleep(WorldState& world, const std::vector<BodyIndex>& island) {
    for (const BodyIndex body : island) {
        if (hasLeftItsBoxes(world, body)) placeBody(world, body, 0);
        world.bodies.motion[body].velocity.setZero();
        world.bodies.motion[body].angularVelocity = 0;
        world.bodies.putToSleep(body);
        world.jointsChanged = world.jointsChanged || !world.bodies.record[body].joints.empty();
    }
    for (const BodyIndex body : island) {
        forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
            ContactRecord& contact = world.contacts.contacts[index];
            if (world.bodies.record[otherOf(contact, body)].awake) {  // looked at as long as that is, but not solved
                if (contact.colour >= 0) settleAnew(world, index);
                return;
            }
            contact.memoryStep = world.lastStep;
            world.graph.remove(world.bodies, world.contacts, index);
            world.contacts.removeNear(index);
        });
    }
}

}  // namespace

void wakeIsland(WorldState& world, BodyIndex seed) {
    if (!world.bodies.canMove(seed)) return;
    std::vector<BodyIndex> reached{seed};
    wakeOne(world, seed);
    for (std::size_t i = 0; i < reached.size(); ++i) {
        forEachNeighbour(world, reached[i], [&](BodyIndex other) {
            if (world.bodies.record[other].awake) return;
            wakeOne(world, other);
            reached.push_back(other);
        });
    }
}

void wakeNeighbours(WorldState& world, BodyIndex body) {
    std::vector<BodyIndex> neighbours;
    forEachNeighbour(world, body, [&](BodyIndex other) { neighbours.push_back(other); });
    for (const BodyIndex other : neighbours) wakeIsland(world, other);
}

void sleepIsland(WorldState& world, BodyIndex body) {
    if (!world.bodies.record[body].awake) return;
    if (!world.bodies.isDynamic(body)) {
        putToSleep(world, {body});
        return;
    }
    std::vector<bool> seen(world.bodies.record.size(), false);
    const std::vector<BodyIndex> island = islandOf(world, body, seen);
    const auto driven = [&world](BodyIndex b) { return drivenFromOutside(world, b); };
    if (std::none_of(island.begin(), island.end(), driven)) putToSleep(world, island);
}

void sleepIslands(WorldState& world, double dt) {
    if (!world.def.sleeping || !countStillness(world, dt)) return;
    std::vector<bool> seen(world.bodies.record.size(), false);
    const std::vector<BodyIndex> awake = world.bodies.awake;
    for (const BodyIndex seed : awake) {
        if (seen[seed] || !world.bodies.isDynamic(seed)) continue;
        const std::vector<BodyIndex> island = islandOf(world, seed, seen);
        const bool still = std::all_of(island.begin(), island.end(), [&](BodyIndex body) {
            return world.bodies.record[body].stillTime >= world.def.solver.sleepTime;
        });
        if (!still) continue;
        putToSleep(world, island);
        world.sleepers.insert(world.sleepers.end(), island.begin(), island.end());
    }
}

}  // namespace plumb
