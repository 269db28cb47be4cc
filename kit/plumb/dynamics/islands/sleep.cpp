// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/sleep.h>

#include <algorithm>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/islands/neighbours.h>
#include <plumb/dynamics/islands/still_islands.h>
#include <plumb/dynamics/islands/stillness.h>

namespace plumb {

namespace {

/// Breadth first along touches and acting joints. Fixed bodies are no neighbours: else all that lies on the ground
/// would be one island.
StepList<BodyIndex> islandOf(const SleepStores& stores, BodyIndex seed) {
    StepList<std::uint8_t> seen(stores.bodies.record.size(), 0);
    StepList<BodyIndex> island{seed};
    seen[seed] = 1;
    for (std::size_t i = 0; i < island.size(); ++i) {
        forEachNeighbour(stores.bodies, stores.contacts, stores.joints, island[i], [&](BodyIndex other) {
            if (seen[other] != 0) return;
            seen[other] = 1;
            island.push_back(other);
        });
    }
    return island;
}

void putContactToSleep(SleepStores& stores, BodyIndex body, ContactIndex index) {
    ContactRecord& contact = stores.contacts[index];
    if (stores.bodies.record[otherOf(contact, body)].awake) {  // it is collided until that one sleeps, but not solved
        if (contact.isSolved()) renewContact(stores.graph, stores.contacts, stores.bodies, index);
        return;
    }
    stores.graph.remove(stores.bodies, stores.contacts, index);
    stores.contacts.removeNear(index);
}

/// First all bodies, then their contacts: only then is it known of which contacts both bodies sleep. What is left of
/// the velocity is below sleepSpeed, or belongs to a body that the program puts to sleep.
void putToSleep(SleepStores& stores, const StepList<BodyIndex>& island) {
    BodyStore& bodies = stores.bodies;
    for (const BodyIndex body : island) {
        // A sleeper's bounds are not placed in any step: they must contain it now.
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

void sleepIsland(SleepStores stores, BodyIndex body) {
    if (!stores.bodies.record[body].awake) return;
    if (!stores.bodies.isDynamic(body)) {
        putToSleep(stores, {body});
        return;
    }
    const StepList<BodyIndex> island = islandOf(stores, body);
    const auto carried = [&](BodyIndex b) { return isCarried(stores.bodies, stores.contacts, stores.joints, b); };
    if (std::none_of(island.begin(), island.end(), carried)) putToSleep(stores, island);
}

StepList<BodyIndex> sleepIslands(SleepStores stores, const SolverSettings& settings, double dt) {
    StepList<BodyIndex> sleepers;
    if (!countStillness(stores.bodies, stores.contacts, stores.joints, settings, dt)) return sleepers;
    for (const StepList<BodyIndex>& island : findStillIslands(stores, settings)) {
        putToSleep(stores, island);
        sleepers.insert(sleepers.end(), island.begin(), island.end());
    }
    return sleepers;
}

}  // namespace plumb
