// SPDX-License-Identifier: MIT
// Which contacts can be solved at once? Those of one colour: no two of them share a body that can be pushed.
#pragma once
#include <array>
#include <vector>

#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/dynamics/contacts/contact_store.h>

namespace plumb {

/// Colours are solved in order. Contacts of two bodies take the lowest colour free at both; those with something fixed
/// start at fixedColour, so that the ground has the last word; what finds no colour goes to the last one, where
/// bodies may repeat and lanes are solved one after the other.
inline constexpr int colourCount = 32;
inline constexpr int fixedColour = 24;
inline constexpr int overflowColour = colourCount - 1;

/// Contacts of one colour and one kind. A batch is full but for the last.
struct Colour {
    std::vector<ContactBatch> batches;
    std::vector<ManifoldLanes> manifolds;  ///< parallel to batches
    std::vector<PairLanes> pairs;          ///< likewise
    std::vector<ContactIndex> contactOf;   ///< slot to contact; slot = batch * batchLanes + lane
};

/// Contacts keep their slot, and in it their impulses, from step to step.
struct ContactGraph {
    /// Of each colour, the contacts of two boxes and then all others.
    std::array<Colour, 2 * colourCount> colours;

    /// With what is known of it in a lane of a batch that is no part of the graph.
    void add(BodyStore& bodies, ContactStore& contacts, ContactIndex contact, const ContactBatch& batch,
             const ManifoldLanes& manifolds, std::size_t lane);
    /// What is known of it goes back to its record. Does nothing to a contact that is not in the graph.
    void remove(BodyStore& bodies, ContactStore& contacts, ContactIndex contact);

    // From the slot where it has one, else from the contact itself:
    std::array<PointMemory, 2> memoryOf(const ContactRecord& contact) const;
    /// Of the last step's start.
    Manifold manifoldOf(const ContactRecord& contact) const;
    /// Of a point of the manifold, where the bodies are now [m].
    float separationOf(const ContactRecord& contact, std::size_t point) const;

private:
    const Colour& colourOf(const ContactRecord& contact) const { return colours[contact.colour]; }
};

/// A contact's normal, and a point half way between the surfaces, in the world, where the bodies are now.
Vec2 normalOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact);
Vec2 pointOf(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact, std::size_t point);

/// Takes a contact out of the graph and the store.
void removeContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact);
/// Puts a contact that is awake back among the near ones, with its impulses: what it was made from has changed.
void renewContact(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex contact);

/// The colour of an entry of ContactGraph.colours.
inline int colourAt(std::size_t index) {
    return static_cast<int>(index / 2);
}

}  // namespace plumb
