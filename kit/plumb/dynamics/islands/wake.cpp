// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/wake.h>

#include <plumb/dynamics/bodies/load_bodies.h>
#include <plumb/dynamics/islands/neighbours.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

namespace {

void wakeOne(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body) {
    if (bodies.record[body].awake) {
        bodies.record[body].stillTime = 0;
        return;
    }
    bodies.wake(body);
    loadBody(bodies, body, bodies.lastStep);
    // Its bounds stay the same until the next step: if the bounds of a pair parted and met again within a step, the
    // pair would be lost.
    bodies.step[body].boundsPending = true;
    joints.changed = joints.changed || !bodies.links[body].joints.empty();
    forEachContact(bodies, contacts, body, [&](ContactIndex contact) { contacts.addNear(contact); });
}

}  // namespace

/// Breadth first, O(bodies and contacts of the island): a sleeping island has no record of its own, its touches and
/// joints are the only trace of it. If a part of it is awake, the search goes no further there: what it touches is
/// awake, too.
void wakeIsland(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex seed) {
    if (!bodies.canMove(seed)) return;
    StepList<BodyIndex> reached{seed};
    wakeOne(bodies, contacts, joints, seed);
    for (std::size_t i = 0; i < reached.size(); ++i) {
        forEachNeighbour(bodies, contacts, joints, reached[i], [&](BodyIndex other) {
            if (bodies.record[other].awake) return;
            wakeOne(bodies, contacts, joints, other);
            reached.push_back(other);
        });
    }
}

void wakeIslands(BodyStore& bodies, ContactStore& contacts, JointStore& joints, std::span<const BodyIndex> named) {
    for (const BodyIndex body : named) wakeIsland(bodies, contacts, joints, body);
}

void wakeNeighbours(BodyStore& bodies, ContactStore& contacts, JointStore& joints, BodyIndex body) {
    StepList<BodyIndex> neighbours;
    forEachNeighbour(bodies, contacts, joints, body, [&](BodyIndex other) { neighbours.push_back(other); });
    wakeIslands(bodies, contacts, joints, neighbours);
}

}  // namespace plumb
