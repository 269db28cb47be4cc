// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/contact_graph.h>

#include <bit>

namespace plumb {

namespace {

int freeColour(std::uint32_t used, int first, int end) {
    const std::uint32_t available = ~used & (~std::uint32_t{0} << first);
    const int colour = std::countr_zero(available);
    return colour < end ? colour : overflowColour;
}

void copyLane(Colour& to, std::size_t toSlot, const ContactBatch& batch, const ManifoldLanes& manifolds,
              std::size_t lane) {
    ContactBatch& target = to.batches[toSlot / batchLanes];
    copyLane(target, toSlot % batchLanes, batch, lane, batchRows);
    copyLane(to.manifolds[toSlot / batchLanes], toSlot % batchLanes, manifolds, lane, manifoldRows);
    target.belts = target.belts || batch.beltSpeed[lane] != 0;
    target.rolls = target.rolls || batch.rollReach[lane] != 0;
    target.bounces = target.bounces || manifolds.restitution[lane] > 0;
}

/// One more, empty; a quarter in reserve, not the half that a vector would take: batches are what a world is made of.
template <class Batch>
void append(std::vector<Batch>& batches) {
    if (batches.size() == batches.capacity()) batches.reserve(batches.size() + batches.size() / 4 + 1);
    batches.push_back(Batch{});
}

int chooseColour(const BodyRecord& a, const BodyRecord& b) {
    const bool pushA = a.type == BodyType::Dynamic;
    const bool pushB = b.type == BodyType::Dynamic;
    const std::uint32_t used = (pushA ? a.colours : 0) | (pushB ? b.colours : 0);
    return pushA && pushB ? freeColour(used, 0, fixedColour) : freeColour(used, fixedColour, overflowColour);
}

}  // namespace

void ContactGraph::add(BodyStore& bodies, ContactStore& contacts, ContactIndex index, const ContactBatch& batch,
                       const ManifoldLanes& manifolds, std::size_t lane) {
    ContactRecord& contact = contacts.contacts[index];
    BodyRecord& a = bodies.record[contact.bodyA];
    BodyRecord& b = bodies.record[contact.bodyB];
    const int chosen = chooseColour(a, b);
    if (chosen != overflowColour) {
        a.colours |= std::uint32_t{1} << chosen;
        b.colours |= std::uint32_t{1} << chosen;
    }
    ++a.solverContacts;
    ++b.solverContacts;
    contacts.removeNear(index);
    contact.colour = 2 * chosen + (contact.boxes ? 0 : 1);
    Colour& colour = colours[static_cast<std::size_t>(contact.colour)];
    const std::size_t slot = colour.contactOf.size();
    if (slot % batchLanes == 0) {
        append(colour.batches);
        append(colour.manifolds);
        append(colour.pairs);
    }
    fillPair(contacts, contact, colour.pairs.back(), slot % batchLanes);
    colour.contactOf.push_back(index);
    contact.slot = static_cast<std::uint32_t>(slot);
    copyLane(colour, slot, batch, manifolds, lane);
}

std::array<PointMemory, 2> ContactGraph::memoryOf(const ContactRecord& contact) const {
    if (contact.colour < 0) return contact.memory;
    const ContactBatch& batch = colourOf(contact).batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    std::array<PointMemory, 2> memory;
    for (std::size_t p = 0; p < 2; ++p) {
        const PointLanes& from = batch.points[p];
        memory[p] = {from.normalImpulse[lane], from.tangentImpulse[lane], from.totalNormal[lane],
                     from.totalTangent[lane]};
    }
    return memory;
}

Manifold ContactGraph::manifoldOf(const ContactRecord& contact) const {
    if (contact.colour < 0) return contact.manifold;
    const ManifoldLanes& lanes = colourOf(contact).manifolds[contact.slot / batchLanes];
    const ContactBatch& batch = colourOf(contact).batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    Manifold manifold;
    manifold.normal = {lanes.normalX[lane], lanes.normalY[lane]};
    manifold.count = lanes.count[lane];
    for (std::size_t p = 0; p < 2; ++p) {
        const ManifoldPointLanes& from = lanes.points[p];
        manifold.points[p] = {{from.x[lane], from.y[lane]},
                              batch.points[p].startSeparation[lane],
                              static_cast<std::uint16_t>(from.feature[lane])};
    }
    return manifold;
}

float ContactGraph::separationOf(const ContactRecord& contact, std::size_t point) const {
    if (contact.colour < 0) return contact.manifold.points[point].separation;
    const ContactBatch& batch = colourOf(contact).batches[contact.slot / batchLanes];
    return batch.points[point].separation[contact.slot % batchLanes];
}

void ContactGraph::remove(BodyStore& bodies, ContactStore& contacts, ContactIndex index) {
    ContactRecord& contact = contacts.contacts[index];
    if (contact.colour < 0) return;
    Colour& colour = colours[static_cast<std::size_t>(contact.colour)];
    const std::size_t slot = contact.slot;
    const std::size_t last = colour.contactOf.size() - 1;
    const int shared = colourAt(static_cast<std::size_t>(contact.colour));
    contact.manifold = manifoldOf(contact);
    contact.memory = memoryOf(contact);
    contact.rollImpulse = colour.batches[slot / batchLanes].rollImpulse[slot % batchLanes];
    for (const BodyIndex body : {contact.bodyA, contact.bodyB}) {
        BodyRecord& record = bodies.record[body];
        --record.solverContacts;
        if (shared != overflowColour) record.colours &= ~(std::uint32_t{1} << shared);
    }
    copyLane(colour, slot, colour.batches.back(), colour.manifolds.back(), last % batchLanes);
    copyLane(colour, last, ContactBatch{}, ManifoldLanes{}, 0);
    copyLane(colour.pairs[slot / batchLanes], slot % batchLanes, colour.pairs.back(), last % batchLanes, pairRows);
    copyLane(colour.pairs.back(), last % batchLanes, PairLanes{}, 0, pairRows);
    colour.contactOf[slot] = colour.contactOf[last];
    contacts.contacts[colour.contactOf[slot]].slot = static_cast<std::uint32_t>(slot);
    colour.contactOf.pop_back();
    if (last % batchLanes == 0) {
        colour.batches.pop_back();
        colour.manifolds.pop_back();
        colour.pairs.pop_back();
    }
    contact.colour = -1;
}

}  // namespace plumb
