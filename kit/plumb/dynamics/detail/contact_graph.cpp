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

void copyLane(ContactBatch& to, std::size_t toLane, const ContactBatch& from, std::size_t fromLane) {
    const auto copy = [&](auto& target, const auto& source) { target[toLane] = source[fromLane]; };
    copy(to.bodyA, from.bodyA);
    copy(to.bodyB, from.bodyB);
    copy(to.normalX, from.normalX);
    copy(to.normalY, from.normalY);
    copy(to.friction, from.friction);
    copy(to.roundA, from.roundA);
    copy(to.roundB, from.roundB);
    for (std::size_t p = 0; p < 2; ++p) {
        PointLanes& t = to.points[p];
        const PointLanes& f = from.points[p];
        copy(t.anchorNormalA, f.anchorNormalA);
        copy(t.anchorTangentA, f.anchorTangentA);
        copy(t.anchorNormalB, f.anchorNormalB);
        copy(t.anchorTangentB, f.anchorTangentB);
        copy(t.startSeparation, f.startSeparation);
        copy(t.separation, f.separation);
        copy(t.normalMass, f.normalMass);
        copy(t.tangentMass, f.tangentMass);
        copy(t.normalImpulse, f.normalImpulse);
        copy(t.tangentImpulse, f.tangentImpulse);
        copy(t.solvedNormal, f.solvedNormal);
        copy(t.solvedTangent, f.solvedTangent);
        copy(t.totalNormal, f.totalNormal);
        copy(t.totalTangent, f.totalTangent);
        copy(t.bounceSpeed, f.bounceSpeed);
    }
}

ContactBatch& batchOf(Colour& colour, std::size_t slot) {
    return colour.batches[slot / batchLanes];
}

}  // namespace

void ContactGraph::add(BodyStore& bodies, ContactStore& contacts, ContactIndex index) {
    ContactRecord& contact = contacts.contacts[index];
    BodyRecord& a = bodies.record[contact.bodyA];
    BodyRecord& b = bodies.record[contact.bodyB];
    const bool pushA = a.type == BodyType::Dynamic;
    const bool pushB = b.type == BodyType::Dynamic;
    const std::uint32_t used = (pushA ? a.colours : 0) | (pushB ? b.colours : 0);
    const int chosen =
        pushA && pushB ? freeColour(used, 0, fixedColour) : freeColour(used, fixedColour, overflowColour);
    if (chosen != overflowColour) {
        if (pushA) a.colours |= std::uint32_t{1} << chosen;
        if (pushB) b.colours |= std::uint32_t{1} << chosen;
    }
    Colour& colour = colours[static_cast<std::size_t>(chosen)];
    const std::size_t slot = colour.contactOf.size();
    if (slot % batchLanes == 0) colour.batches.emplace_back();
    colour.contactOf.push_back(index);
    contact.colour = chosen;
    contact.slot = static_cast<std::uint32_t>(slot);
    copyLane(batchOf(colour, slot), slot % batchLanes, ContactBatch{}, 0);
    setImpulses(contact, contact.memory);
}

std::array<PointMemory, 2> ContactGraph::memoryOf(const ContactRecord& contact) const {
    if (contact.colour < 0) return contact.memory;
    const ContactBatch& batch = colours[static_cast<std::size_t>(contact.colour)].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    std::array<PointMemory, 2> memory;
    for (std::size_t p = 0; p < 2; ++p) {
        const PointLanes& from = batch.points[p];
        memory[p] = {from.normalImpulse[lane], from.tangentImpulse[lane], from.totalNormal[lane],
                     from.totalTangent[lane]};
    }
    return memory;
}

float ContactGraph::separationOf(const ContactRecord& contact, std::size_t point) const {
    if (contact.colour < 0) return contact.manifold.points[point].separation;
    const Colour& colour = colours[static_cast<std::size_t>(contact.colour)];
    return colour.batches[contact.slot / batchLanes].points[point].separation[contact.slot % batchLanes];
}

void ContactGraph::setImpulses(const ContactRecord& contact, const std::array<PointMemory, 2>& memory) {
    ContactBatch& batch = batchOf(colours[static_cast<std::size_t>(contact.colour)], contact.slot);
    for (std::size_t p = 0; p < 2; ++p) {
        batch.points[p].normalImpulse[contact.slot % batchLanes] = memory[p].normalImpulse;
        batch.points[p].tangentImpulse[contact.slot % batchLanes] = memory[p].tangentImpulse;
    }
}

void ContactGraph::remove(BodyStore& bodies, ContactStore& contacts, ContactIndex index) {
    ContactRecord& contact = contacts.contacts[index];
    if (contact.colour < 0) return;
    Colour& colour = colours[static_cast<std::size_t>(contact.colour)];
    const std::size_t slot = contact.slot;
    const std::size_t last = colour.contactOf.size() - 1;
    ContactBatch& batch = batchOf(colour, slot);
    contact.memory = memoryOf(contact);
    if (contact.colour != overflowColour) {
        const std::uint32_t keep = ~(std::uint32_t{1} << contact.colour);
        bodies.record[contact.bodyA].colours &= keep;
        bodies.record[contact.bodyB].colours &= keep;
    }
    ContactBatch& lastBatch = batchOf(colour, last);
    if (slot != last) {
        copyLane(batch, slot % batchLanes, lastBatch, last % batchLanes);
        colour.contactOf[slot] = colour.contactOf[last];
        contacts.contacts[colour.contactOf[slot]].slot = static_cast<std::uint32_t>(slot);
    }
    colour.contactOf.pop_back();
    if (last % batchLanes == 0)
        colour.batches.pop_back();
    else
        copyLane(lastBatch, last % batchLanes, ContactBatch{}, 0);
    contact.colour = -1;
}

}  // namespace plumb
