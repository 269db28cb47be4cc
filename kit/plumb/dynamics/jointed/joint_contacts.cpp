// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_contacts.h>

#include <cmath>

#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/contact_point.h>

namespace plumb {

void JointedContacts::setMasses(JointStores& stores) const {
    for (const ContactBody& seen : seen_)
        setSolverMass(*stores.graph, *stores.contacts, *stores.bodies, seen.body, static_cast<float>(1 / seen.mass),
                      seen.inertia > 0 ? static_cast<float>(std::sqrt(seen.mass / seen.inertia)) : 0.0f);
}

/// Calls visit(contact, its lane, its pass) where islands have changed.
template <class Visit>
void JointedContacts::forEachChanged(const JointStores& stores, Visit&& visit) const {
    for (const Jointed& one : some_) {
        if (!one.batch->contacts.hasChanged(one.lane)) continue;
        const ContactRecord& contact = (*stores.contacts)[one.contact];
        visit(one, stores.graph->laneOf(contact), stores.passes.of(isOfGround(contact.colour)));
    }
}

/// Returns true if an island has changed. If none can, the loads are noted at once, while the numbers are at hand.
bool JointedContacts::respondOnce(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn) {
    bool changed = false;
    for (JointBatch& batch : batches) {
        const LaneFlags touched = batch.respondToContacts(*stores.bodies, turn);
        changed = batch.contacts.findChanged(batch.numbers, *stores.bodies, touched) || changed;
        if (some_.empty()) batch.note(stores.observer);
    }
    return changed;
}

/// Takes the contacts back, and solves them with the masses that their bodies have now.
void JointedContacts::solveAgain(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn) {
    const SolverBodies bodies = stores.bodies->solverBodies();
    forEachChanged(stores, [&](const Jointed& one, const ContactLane& at, const ContactPass&) {
        takeBackLane(at.batch, at.lane, bodies, one.start);
    });
    seen_.clear();
    for (JointBatch& batch : batches) batch.respondToContacts(*stores.bodies, turn);
    for (JointBatch& batch : batches) batch.contacts.findChangedBodies(batch.numbers, *stores.bodies, seen_);
    setMasses(stores);
    forEachChanged(stores, [&](const Jointed& one, const ContactLane& at, const ContactPass& pass) {
        turn.correct ? solveLane(at.batch, at.lane, bodies, pass)
                     : relaxLane(at.batch, at.lane, bodies, pass, one.start);
    });
}

void JointedContacts::find(const JointStores& stores, std::span<const JointIsland> islands) {
    some_.clear();
    for (const JointIsland& island : islands) {
        if (island.isSwept() || !mayChange(island.batch->numbers, island.lane)) continue;
        for (std::size_t node = 0; node < island.bodies.size(); ++node)
            forEachContact(*stores.bodies, *stores.contacts, island.bodies[node], [&](ContactIndex index) {
                const ContactRecord& contact = (*stores.contacts)[index];
                if (!contact.isSolved()) return;
                some_.push_back({island.batch, island.lane, index, {}});
                const ContactLane at = stores.graph->laneOf(contact);
                const double sign = contact.bodyB == island.bodies[node] ? 1 : -1;
                addNormal(island.batch->numbers, island.lane, node, sign * normalAt(at.batch, at.lane));
            });
    }
}

void JointedContacts::start(JointStores& stores, std::span<JointBatch> batches, bool isFirst) {
    seen_.clear();
    for (JointBatch& batch : batches) batch.contacts.findBodies(batch.numbers, *stores.bodies, isFirst, seen_);
    setMasses(stores);
    for (Jointed& one : some_) {
        const ContactLane at = stores.graph->laneOf((*stores.contacts)[one.contact]);
        one.start = impulsesOf(at.batch, at.lane);
    }
}

void JointedContacts::respond(JointStores& stores, std::span<JointBatch> batches, const IslandTurn& turn) {
    constexpr int mostRounds = 3;  // in the last one no stop counts: contacts give too little rather than too much
    for (int round = 1; respondOnce(stores, batches, turn) && round <= mostRounds; ++round) {
        for (JointBatch& batch : batches) batch.contacts.noteLoadedStops(batch.numbers, round < mostRounds);
        solveAgain(stores, batches, turn);
    }
    if (some_.empty()) return;
    for (JointBatch& batch : batches) batch.note(stores.observer);
}

}  // namespace plumb
