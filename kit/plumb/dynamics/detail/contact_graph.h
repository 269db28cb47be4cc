// SPDX-License-Identifier: MIT
// Which contacts can be solved at once? Those of one colour: no two of them share a body that can be pushed.
#pragma once
#include <array>
#include <vector>

#include <plumb/dynamics/detail/contact_batch.h>
#include <plumb/dynamics/detail/contact_store.h>

namespace plumb {

/// Colours are solved in order. Contacts of two bodies take the lowest colour free at both; those with something fixed
/// start at fixedColour, so that the ground has the last word; what finds no colour goes to the last one, where
/// bodies may repeat and lanes are solved one after the other.
inline constexpr int colourCount = 32;
inline constexpr int fixedColour = 24;
inline constexpr int overflowColour = colourCount - 1;

struct Colour {
    std::vector<ContactBatch> batches;
    std::vector<ContactIndex> contactOf;  ///< slot to contact; slot = batch * batchLanes + lane
};

/// Contacts keep their slot, and in it their impulses, from step to step.
struct ContactGraph {
    std::array<Colour, colourCount> colours;

    void add(BodyStore& bodies, ContactStore& contacts, ContactIndex contact);
    /// Impulses go back to the contact's memory. Does nothing to a contact that is not in the graph.
    void remove(BodyStore& bodies, ContactStore& contacts, ContactIndex contact);

    /// From the slot where it has one, else from the contact itself.
    std::array<PointMemory, 2> memoryOf(const ContactRecord& contact) const;
    /// Of a point of the manifold, where the bodies are now [m].
    float separationOf(const ContactRecord& contact, std::size_t point) const;
    /// Into the slot, for warm starting.
    void setImpulses(const ContactRecord& contact, const std::array<PointMemory, 2>& memory);
};

}  // namespace plumb
