// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/contact_graph.h>

#include <algorithm>
#include <bit>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/math/detail/sorting.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

namespace {

/// Greedy colouring with one bit for each colour: the lowest colour that is free at both bodies, or the overflow
/// colour. O(1). Low colours fill first, so that batches are full.
int freeColour(std::uint32_t used, int first, int end) {
    const std::uint32_t available = ~used & (~std::uint32_t{0} << first);
    const int colour = std::countr_zero(available);
    return colour < end ? colour : overflowColour;
}

/// The flags of a batch only say that some lane may need the code. They are never cleared: that would take a look at
/// all lanes, and a batch that is empty is removed.
void noteFlags(const ContactLane& at) {
    ContactBatch& batch = at.batch;
    batch.hasSurfaceSpeed = batch.hasSurfaceSpeed || batch.surfaceSpeed[at.lane] != 0;
    batch.hasRollingResistance = batch.hasRollingResistance || batch.rollingArm[at.lane] != 0;
    batch.bounces = batch.bounces || at.manifolds.restitution[at.lane] > 0;
}

/// Copies all that a colour has of a contact, but its number.
void copySlot(Colour& to, std::size_t toSlot, const Colour& from, std::size_t fromSlot) {
    const std::size_t t = toSlot / batchLanes, lane = toSlot % batchLanes, f = fromSlot / batchLanes,
                      fromLane = fromSlot % batchLanes;
    copyLane(to.batches[t], lane, from.batches[f], fromLane, batchRows);
    copyLane(to.manifolds[t], lane, from.manifolds[f], fromLane, manifoldRows);
    copyLane(to.pairs[t], lane, from.pairs[f], fromLane, pairRows);
    if (!to.kept.empty() && !from.kept.empty()) copyLane(to.kept[t], lane, from.kept[f], fromLane, keptRows);
    noteFlags({to.batches[t], to.manifolds[t], lane});
}

/// A colour with one batch that is empty.
Colour emptyColour() {
    return {{ContactBatch{}}, {ManifoldLanes{}}, {PairLanes{}}, {KeptLanes{}}, {}};
}

/// Brings to a slot the contact that belongs there, to that one's slot the next, and so on around.
void moveAround(Colour& colour, StepList<std::uint32_t>& from, std::uint32_t start, Colour& spare) {
    if (from[start] == start) return;
    copySlot(spare, 0, colour, start);
    const ContactIndex first = colour.contactOf[start];
    std::uint32_t slot = start;
    for (std::uint32_t next = from[slot]; next != start; next = from[slot]) {
        copySlot(colour, slot, colour, next);
        colour.contactOf[slot] = colour.contactOf[next];
        from[slot] = slot;
        slot = next;
    }
    copySlot(colour, slot, spare, 0);
    colour.contactOf[slot] = first;
    from[slot] = slot;
}

/// Appends an empty batch. The capacity grows by a quarter, less than a vector's own growth: batches take most of a
/// world's memory.
template <class Batch>
void append(std::vector<Batch>& batches) {
    if (batches.size() == batches.capacity()) batches.reserve(batches.size() + batches.size() / 4 + 1);
    batches.push_back(Batch{});
}

/// A body that no impulse moves may be in several lanes of a batch: its velocity is stored as it was loaded. So its
/// colours are not asked; else a floor would use all of them up.
int chooseColour(const BodyStore& bodies, BodyIndex a, BodyIndex b) {
    const bool pushA = bodies.isDynamic(a), pushB = bodies.isDynamic(b);
    const std::uint32_t used = (pushA ? bodies.links[a].colours : 0) | (pushB ? bodies.links[b].colours : 0);
    return pushA && pushB ? freeColour(used, 0, fixedColour) : freeColour(used, fixedColour, overflowColour);
}

}  // namespace

/// Only the narrow phase adds contacts, when their shapes begin to touch or may touch in the step. Before and after:
/// all batches of a colour but the last are full, and contact, slot and lane name each other.
void ContactGraph::add(BodyStore& bodies, ContactStore& contacts, ContactIndex index, const ContactBatch& batch,
                       const ManifoldLanes& manifolds, std::size_t lane) {
    ContactRecord& contact = contacts[index];
    BodyLinks& a = bodies.links[contact.bodyA];
    BodyLinks& b = bodies.links[contact.bodyB];
    const int chosen = chooseColour(bodies, contact.bodyA, contact.bodyB);
    if (chosen != overflowColour) {
        a.colours |= std::uint32_t{1} << chosen;
        b.colours |= std::uint32_t{1} << chosen;
    }
    ++a.solverContacts;
    ++b.solverContacts;
    contacts.removeNear(index);
    contact.state = ContactState::Solved;
    contact.colour = static_cast<std::uint32_t>(2 * chosen + (contact.boxes ? 0 : 1));
    Colour& colour = colours[contact.colour];
    const std::size_t slot = colour.contactOf.size();
    if (slot % batchLanes == 0) {
        append(colour.batches);
        append(colour.manifolds);
        append(colour.pairs);
        if (!contact.boxes) append(colour.kept);
    }
    colour.contactOf.push_back(index);
    contact.slot = static_cast<std::uint32_t>(slot);
    const ContactLane to = laneOf(contact);
    copyLane(to.batch, to.lane, batch, lane, batchRows);
    copyLane(to.manifolds, to.lane, manifolds, lane, manifoldRows);
    fillPair(contacts, contact, colour.pairs.back(), to.lane);
    noteFlags(to);
}

void ContactGraph::sortOverflow(ContactStore& contacts) {
    if (spare_.batches.empty()) spare_ = emptyColour();
    for (std::size_t kind = 0; kind < 2; ++kind) {
        Colour& colour = colours[2 * static_cast<std::size_t>(overflowColour) + kind];
        // Sorted every step, but hardly ever out of order: the test is O(n). Test: "a crowd that bounces 1 km away does
        // not change a bit of how 60 bodies pile up"
        const auto comesFirst = [&contacts](ContactIndex a, ContactIndex b) {
            return shapesOf(contacts[a]) < shapesOf(contacts[b]);
        };
        if (std::is_sorted(colour.contactOf.begin(), colour.contactOf.end(), comesFirst)) continue;
        StepList<std::uint32_t> from = sortedOrder(colour.contactOf.size(), [&](std::uint32_t a, std::uint32_t b) {
            return comesFirst(colour.contactOf[a], colour.contactOf[b]);
        });
        for (std::uint32_t start = 0; start < from.size(); ++start) moveAround(colour, from, start, spare_);
        for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot)
            contacts[colour.contactOf[slot]].slot = static_cast<std::uint32_t>(slot);
    }
}

std::array<PointMemory, 2> ContactGraph::memoryOf(const ContactRecord& contact) const {
    if (!contact.isSolved()) return contact.memory;
    const ConstContactLane at = laneOf(contact);
    const std::size_t lane = at.lane;
    std::array<PointMemory, 2> memory;
    for (std::size_t p = 0; p < 2; ++p) {
        const PointLanes& from = at.batch.points[p];
        memory[p] = {from.normalImpulse[lane], from.tangentImpulse[lane], from.totalNormal[lane],
                     from.totalTangent[lane]};
    }
    return memory;
}

Manifold ContactGraph::manifoldOf(const ContactRecord& contact) const {
    if (!contact.isSolved()) return contact.manifold;
    const ConstContactLane at = laneOf(contact);
    const std::size_t lane = at.lane;
    Manifold manifold;
    manifold.normal = {at.manifolds.normalX[lane], at.manifolds.normalY[lane]};
    manifold.count = at.manifolds.count[lane];
    for (std::size_t p = 0; p < 2; ++p) {
        const ManifoldPointLanes& from = at.manifolds.points[p];
        manifold.points[p] = {{from.x[lane], from.y[lane]},
                              at.batch.points[p].startSeparation[lane],
                              static_cast<std::uint16_t>(from.feature[lane])};
    }
    return manifold;
}

float ContactGraph::separationOf(const ContactRecord& contact, std::size_t point) const {
    if (!contact.isSolved()) return contact.manifold.points[point].separation;
    const ConstContactLane at = laneOf(contact);
    return at.batch.points[point].separation[at.lane];
}

/// The record gets the manifold and the impulses, so that a contact that comes back, or wakes, starts with its load.
/// The caller puts it among the near contacts, or leaves it asleep.
void ContactGraph::remove(BodyStore& bodies, ContactStore& contacts, ContactIndex index) {
    ContactRecord& contact = contacts[index];
    if (!contact.isSolved()) return;
    Colour& colour = colours[contact.colour];
    const std::size_t slot = contact.slot;
    const std::size_t last = colour.contactOf.size() - 1;
    const int shared = colourAt(contact.colour);
    contact.manifold = manifoldOf(contact);
    contact.memory = memoryOf(contact);
    contact.memoryStep = bodies.lastSolved;
    contact.rollImpulse = laneOf(contact).batch.rollImpulse[laneOf(contact).lane];
    for (const BodyIndex body : {contact.bodyA, contact.bodyB}) {
        BodyLinks& links = bodies.links[body];
        --links.solverContacts;
        if (shared != overflowColour) links.colours &= ~(std::uint32_t{1} << shared);
    }
    // The last contact moves into the gap. Its old lane is emptied, not just forgotten: whole vectors are solved, and
    // bodies and masses of unused lanes must be 0.
    copySlot(colour, slot, colour, last);
    static const Colour empty = emptyColour();
    copySlot(colour, last, empty, 0);
    colour.contactOf[slot] = colour.contactOf[last];
    contacts[colour.contactOf[slot]].slot = static_cast<std::uint32_t>(slot);
    colour.contactOf.pop_back();
    if (last % batchLanes == 0) {
        colour.batches.pop_back();
        colour.manifolds.pop_back();
        colour.pairs.pop_back();
        if (!contact.boxes) colour.kept.pop_back();
    }
    contact.state = ContactState::Asleep;
}

Vec2 normalOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact) {
    return bodies.motion[contact.bodyA].rotation * Vec2(graph.manifoldOf(contact).normal.cast<double>());
}

Vec2 pointOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact, std::size_t point) {
    // The manifold's points were made at the step's start, half-way between the surfaces. A predicted point is
    // different: it is where the two would meet, on A's surface. Both have moved with A; the separation gives the place
    // of B's surface.
    const Manifold m = graph.manifoldOf(contact);
    const ManifoldPoint& p = m.points[point];
    const float nearest = m.count == 2 ? std::min(m.points[0].separation, m.points[1].separation) : p.separation;
    const double begun = nearest > contactMargin ? 0 : static_cast<double>(p.separation);
    const BodyMotion& a = bodies.motion[contact.bodyA];
    const Vec2 there = a.center + a.rotation * Vec2(p.position.cast<double>());
    const double closed = static_cast<double>(graph.separationOf(contact, point)) - begun;
    return there + normalOf(graph, bodies, contact) * (0.5 * closed);
}

void removeContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact) {
    graph.remove(bodies, contacts, contact);
    contacts.remove(bodies, contact);
}

/// Edits call it between steps, and sleep for a contact with a body that stays awake. Near contacts keep their impulses
/// in their records: if it still touches, the next narrow phase puts it back with its load.
void renewContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact) {
    if (contacts[contact].state == ContactState::Asleep) return;  // it is updated when it wakes
    graph.remove(bodies, contacts, contact);
    contacts.removeNear(contact);
    contacts.addNear(contact);
}

}  // namespace plumb
