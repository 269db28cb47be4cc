// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/sleep.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/islands/neighbours.h>

namespace plumb {

namespace {

/// Does an awake kinematic body touch this body, or is it joined to it?
bool isDriven(const SleepStores& stores, BodyIndex body) {
    const BodyStore& bodies = stores.bodies;
    const auto drives = [&](BodyIndex other) {
        return bodies.record[other].type == BodyType::Kinematic && bodies.record[other].awake;
    };
    bool driven = false;
    forEachContact(bodies, stores.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = stores.contacts[index];
        driven = driven || (contact.touching && drives(otherOf(contact, body)));
    });
    for (const JointIndex joint : bodies.links[body].joints)
        forEachBody(stores.joints, joint, [&](BodyIndex end) { driven = driven || drives(end); });
    return driven;
}

bool isStill(const SleepStores& stores, const SolverSettings& settings, BodyIndex body) {
    const BodyStore& bodies = stores.bodies;
    const BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const double speed = motion.velocity.norm() + std::fabs(motion.angularVelocity) * record.boundingRadius;
    // A body without contacts or joints drifts on, however slowly; only a body that the solver moves may be stopped.
    if (!bodies.isMovedBy(body, MovedBy::Solver)) return speed == 0;
    // A body that position correction pushes has no velocity from that, but it moves.
    const SolverDisplacement& moved = bodies.displacement[body];
    const double shift = std::hypot(static_cast<double>(moved.x), static_cast<double>(moved.y));
    return std::max(speed, shift / bodies.lastStep) < settings.sleepSpeed && !isDriven(stores, body);
}

/// Counts the time that each body has been still. Returns whether any has been still for long enough.
bool countStillness(const SleepStores& stores, const SolverSettings& settings, double dt) {
    bool anyReady = false;
    for (const BodyIndex body : stores.bodies.awake) {
        BodyRecord& record = stores.bodies.record[body];
        if (record.type != BodyType::Dynamic) continue;
        record.stillTime = record.canSleep && isStill(stores, settings, body) ? record.stillTime + dt : 0;
        anyReady = anyReady || record.stillTime >= settings.sleepTime;
    }
    return anyReady;
}

std::vector<BodyIndex> islandOf(const SleepStores& stores, BodyIndex seed, std::vector<bool>& seen) {
    std::vector<BodyIndex> island{seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < island.size(); ++i) {
        forEachNeighbour(stores.bodies, stores.contacts, stores.joints, island[i], [&](BodyIndex other) {
            if (seen[other]) return;
            seen[other] = true;
            island.push_back(other);
        });
    }
    return island;
}

void putContactToSleep(const SleepStores& stores, BodyIndex body, ContactIndex index) {
    ContactRecord& contact = stores.contacts[index];
    if (stores.bodies.record[otherOf(contact, body)].awake) {  // it is collided until that one sleeps, but not solved
        if (contact.isSolved()) renewContact(stores.graph, stores.contacts, stores.bodies, index);
        return;
    }
    contact.memoryStep = stores.bodies.lastStep;
    stores.graph.remove(stores.bodies, stores.contacts, index);
    stores.contacts.removeNear(index);
}

void putToSleep(const SleepStores& stores, const std::vector<BodyIndex>& island) {
    BodyStore& bodies = stores.bodies;
    for (const BodyIndex body : island) {
        if (hasLeftItsBounds(stores.space, bodies, body)) placeBounds(stores.space, bodies, stores.contacts, body, 0);
        bodies.motion[body].velocity.setZero();
        bodies.motion[body].angularVelocity = 0;
        bodies.putToSleep(body);
        stores.joints.changed = stores.joints.changed || !bodies.links[body].joints.empty();
    }
    for (const BodyIndex body : island)
        forEachContact(bodies, stores.contacts, body,
                       [&](ContactIndex index) { putContactToSleep(stores, body, index); });
}

}  // namespace

void sleepIsland(const SleepStores& stores, BodyIndex body) {
    if (!stores.bodies.record[body].awake) return;
    if (!stores.bodies.isDynamic(body)) {
        putToSleep(stores, {body});
        return;
    }
    std::vector<bool> seen(stores.bodies.record.size(), false);
    const std::vector<BodyIndex> island = islandOf(stores, body, seen);
    const auto driven = [&stores](BodyIndex b) { return isDriven(stores, b); };
    if (std::none_of(island.begin(), island.end(), driven)) putToSleep(stores, island);
}

std::vector<BodyIndex> sleepIslands(const SleepStores& stores, const SolverSettings& settings, double dt) {
    std::vector<BodyIndex> sleepers;
    if (!countStillness(stores, settings, dt)) return sleepers;
    std::vector<bool> seen(stores.bodies.record.size(), false);
    const std::vector<BodyIndex> awake = stores.bodies.awake;
    for (const BodyIndex seed : awake) {
        if (seen[seed] || !stores.bodies.isDynamic(seed)) continue;
        const std::vector<BodyIndex> island = islandOf(stores, seed, seen);
        const bool still = std::all_of(island.begin(), island.end(), [&](BodyIndex body) {
            return stores.bodies.record[body].stillTime >= settings.sleepTime;
        });
        if (!still) continue;
        putToSleep(stores, island);
        sleepers.insert(sleepers.end(), island.begin(), island.end());
    }
    return sleepers;
}

}  // namespace plumb
