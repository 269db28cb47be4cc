// SPDX-License-Identifier: MIT
// Which contacts can be solved at the same time? Those of one colour: no two of them share a dynamic body.
#pragma once
#include <array>
#include <vector>

#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/dynamics/contacts/contact_store.h>

namespace plumb {

/// Colours are solved in order. A contact of two dynamic bodies gets the lowest colour that is free at both. A contact
/// with a static or kinematic body gets a colour from fixedColour on, so that it is solved last and its error is
/// smallest. A contact for which no colour is free gets the last one, in which bodies may repeat and lanes are solved
/// one after the other. A body has a bit of a word for each colour: 24 for contacts with others that move, 7 with fixed
/// ones.
inline constexpr int colourCount = 32;
inline constexpr int fixedColour = 24;
/// The bits of all colours of contacts of two dynamic bodies, in BodyLinks.colours.
inline constexpr std::uint32_t looseColours = (std::uint32_t{1} << fixedColour) - 1;
inline constexpr int overflowColour = colourCount - 1;

/// Contacts of one colour and one kind. All batches but the last are full.
struct Colour {
    std::vector<ContactBatch> batches;
    std::vector<ManifoldLanes> manifolds;  ///< parallel to batches
    std::vector<PairLanes> pairs;          ///< parallel to batches
    std::vector<KeptLanes> kept;           ///< parallel to batches; empty for contacts of two boxes
    std::vector<ContactIndex> contactOf;   ///< slot to contact; slot = batch * batchLanes + lane
};

/// Where the solver has a contact: a lane of a batch.
template <class Batch, class Manifolds>
struct SolvedLane {
    Batch& batch;
    Manifolds& manifolds;
    std::size_t lane;
};
using ContactLane = SolvedLane<ContactBatch, ManifoldLanes>;
using ConstContactLane = SolvedLane<const ContactBatch, const ManifoldLanes>;

/// All contacts that are in the solver. A contact keeps its slot, and in it its impulses, from step to step.
struct ContactGraph {
    /// Two entries for each colour: the contacts of two boxes, then all others.
    std::array<Colour, 2 * colourCount> colours;

    /// Adds a contact. Its data is copied from a lane of a batch that is not part of the graph.
    void add(BodyStore& bodies, ContactStore& contacts, ContactIndex contact, const ContactBatch& batch,
             const ManifoldLanes& manifolds, std::size_t lane);
    /// Removes a contact and copies its data back to its record. Does nothing if the contact is not in the graph.
    void remove(BodyStore& bodies, ContactStore& contacts, ContactIndex contact);

    /// Puts the contacts of the overflow colour, which are solved one after the other, in the order of their shapes.
    /// The order of their slots changes with each contact that goes, also far away.
    void sortOverflow(ContactStore& contacts);

    /// Of a contact in the solver.
    ContactLane laneOf(const ContactRecord& contact) { return laneIn(colours[contact.colour], contact.slot); }
    ConstContactLane laneOf(const ContactRecord& contact) const {
        return laneIn(colours[contact.colour], contact.slot);
    }
    /// Calls visit(its lane, contact) for all of them, in the order in which they are solved.
    template <class Visit>
    void forEachLane(Visit&& visit) const {
        for (const Colour& colour : colours)
            for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot)
                visit(laneIn(colour, slot), colour.contactOf[slot]);
    }
    /// Calls visit(contact) for those of batches in which some lane has restitution.
    template <class Visit>
    void forEachBouncing(Visit&& visit) const {
        for (const Colour& colour : colours)
            for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot)
                if (colour.batches[slot / batchLanes].bounces) visit(colour.contactOf[slot]);
    }

    // These read from the contact's slot if it has one, else from its record.
    std::array<PointMemory, 2> memoryOf(const ContactRecord& contact) const;
    /// The manifold at the start of the last step.
    Manifold manifoldOf(const ContactRecord& contact) const;
    /// The separation at a point of the manifold, at the bodies' present places [m].
    float separationOf(const ContactRecord& contact, std::size_t point) const;

private:
    static ContactLane laneIn(Colour& colour, std::size_t slot) {
        return {colour.batches[slot / batchLanes], colour.manifolds[slot / batchLanes], slot % batchLanes};
    }
    static ConstContactLane laneIn(const Colour& colour, std::size_t slot) {
        return {colour.batches[slot / batchLanes], colour.manifolds[slot / batchLanes], slot % batchLanes};
    }

    Colour spare_;  ///< room for one contact, to sort others
};

/// A contact's normal, and a point half-way between the surfaces, in the world, at the bodies' present places.
Vec2 normalOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact);
Vec2 pointOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact, std::size_t point);

/// Removes a contact from the graph and from the store.
void removeContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact);
/// Moves an awake contact back to the near contacts, and keeps its impulses. For a contact whose shapes or bodies have
/// changed.
void renewContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact);

/// Does an entry of ContactGraph.colours hold the contacts of two boxes?
inline bool isOfBoxes(std::size_t index) {
    return index % 2 == 0;
}
/// The colour of an entry of ContactGraph.colours.
inline int colourAt(std::size_t index) {
    return static_cast<int>(index / 2);
}
/// Does an entry of ContactGraph.colours hold contacts with static and kinematic bodies?
inline bool isOfGround(std::size_t index) {
    return colourAt(index) >= fixedColour && colourAt(index) != overflowColour;
}

}  // namespace plumb
