// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_contacts.h>

#include <cmath>

#include <plumb/dynamics/contacts/contact_lane.h>

namespace plumb {

namespace {

/// The slot of a contact in the solver.
struct ContactSlot {
    ContactBatch& batch;
    std::size_t lane;
    bool isGround;

    ContactSlot(ContactGraph& graph, const ContactRecord& contact)
        : batch(graph.colours[contact.colour].batches[contact.slot / batchLanes]),
          lane(contact.slot % batchLanes),
          isGround(colourAt(contact.colour) >= fixedColour && colourAt(contact.colour) != overflowColour) {}
    Vec2 normal() const { return {static_cast<double>(batch.normalX[lane]), static_cast<double>(batch.normalY[lane])}; }
};

void setMasses(BodyStore& bodies, const JointedContacts& jointed, const std::vector<ContactBody>& some) {
    for (const ContactBody& seen : some)
        setSolverMass(jointed.graph, jointed.contacts, bodies, seen.body, static_cast<float>(1 / seen.mass),
                      seen.inertia > 0 ? static_cast<float>(std::sqrt(seen.mass / seen.inertia)) : 0.0f);
}

/// Calls visit(contact, its slot) where islands have changed.
template <class Visit>
void forEachChanged(const JointedContacts& jointed, Visit&& visit) {
    for (const JointedContact& one : jointed.some)
        if (one.batch->contacts.hasChanged(one.lane))
            visit(one, ContactSlot(jointed.graph, jointed.contacts[one.contact]));
}

/// Returns true if an island has changed. If none can, the loads are noted at once, while the numbers are at hand.
bool respondToContacts(const JointStores& stores, const JointHalf& half, bool mayChange) {
    bool changed = false;
    for (JointBatch& batch : batchesOf(stores)) {
        const LaneFlags touched = batch.respondToContacts(stores.bodies, turnOf(stores, half));
        changed = batch.contacts.findChanged(batch.numbers, stores.bodies, touched) || changed;
        if (!mayChange) batch.note(stores.observer);
    }
    return changed;
}

void takeBack(const JointStores& stores, const JointHalf& half, const JointedContacts& jointed) {
    const SolverBodies bodies = stores.bodies.solverBodies();
    forEachChanged(jointed, [&](const JointedContact& one, const ContactSlot& slot) {
        takeBackLane(slot.batch, slot.lane, bodies, one.start);
    });
    for (JointBatch& batch : batchesOf(stores)) batch.respondToContacts(stores.bodies, turnOf(stores, half));
}

void solveContactsAgain(const JointStores& stores, const JointHalf& half, const JointedContacts& jointed) {
    std::vector<ContactBody> changed;
    for (JointBatch& batch : batchesOf(stores)) batch.contacts.findChangedBodies(batch.numbers, stores.bodies, changed);
    setMasses(stores.bodies, jointed, changed);
    const SolverBodies bodies = stores.bodies.solverBodies();
    forEachChanged(jointed, [&](const JointedContact& one, const ContactSlot& slot) {
        const ContactPass& pass = slot.isGround ? jointed.groundPass : jointed.pass;
        if (half.correct)
            solveLane(slot.batch, slot.lane, bodies, pass);
        else
            relaxLane(slot.batch, slot.lane, bodies, pass, one.start);
    });
}

}  // namespace

void findJointedContacts(const JointStores& stores, JointedContacts& jointed) {
    jointed.some.clear();
    for (const JointIsland& island : stores.islands.islands) {
        if (island.isSwept() || !mayChange(island.batch->numbers, island.lane)) continue;
        for (std::size_t node = 0; node < island.bodies.size(); ++node)
            forEachContact(stores.bodies, jointed.contacts, island.bodies[node], [&](ContactIndex index) {
                const ContactRecord& contact = jointed.contacts[index];
                if (!contact.isSolved()) return;
                jointed.some.push_back({island.batch, island.lane, index, {}});
                const double sign = contact.bodyB == island.bodies[node] ? 1 : -1;
                addNormal(island.batch->numbers, island.lane, node,
                          sign * ContactSlot(jointed.graph, contact).normal());
            });
    }
}

void startContacts(const JointStores& stores, const JointHalf& half, JointedContacts& jointed) {
    std::vector<ContactBody> seen;
    for (JointBatch& batch : batchesOf(stores))
        batch.contacts.findBodies(batch.numbers, stores.bodies, half.isFirst, seen);
    setMasses(stores.bodies, jointed, seen);
    for (JointedContact& one : jointed.some) {
        const ContactSlot slot(jointed.graph, jointed.contacts[one.contact]);
        one.start = impulsesOf(slot.batch, slot.lane);
    }
}

void respondToContacts(const JointStores& stores, const JointHalf& half, const JointedContacts& jointed) {
    constexpr int mostRounds = 3;  // in the last one no stop counts: contacts give too little rather than too much
    const bool mayChange = !jointed.some.empty();
    for (int round = 1; respondToContacts(stores, half, mayChange) && round <= mostRounds; ++round) {
        for (JointBatch& batch : batchesOf(stores)) batch.contacts.noteLoadedStops(batch.numbers, round < mostRounds);
        takeBack(stores, half, jointed);
        solveContactsAgain(stores, half, jointed);
    }
    if (!mayChange) return;
    for (JointBatch& batch : batchesOf(stores)) batch.note(stores.observer);
}

}  // namespace plumb
