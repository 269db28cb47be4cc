// SPDX-License-Identifier: MIT
// Which contacts in the solver have come to a joint of a floor of several shapes?
//
// Most contacts at corners are in heaps at rest, where nothing has changed since they were looked at. A contact is
// looked at again only if it, or another contact of one of its loose bodies, was collided again or is new.
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/pair_collider.h>
#include <plumb/space/space.h>

namespace plumb {

class CornerWatch {
public:
    CornerWatch(const ContactStore& contacts, const BodyStore& bodies, const Space& space, double dt);

    /// Notes the contacts at corners in a batch of the solver, and which contacts have moved. kept: of the batch, or
    /// null if manifolds are not kept.
    void note(const PairBatch& batch, KeptLanes* kept, const FreshLanes& fresh);
    /// A contact that is not in the solver has shapes that meet.
    void markMoved(const ContactRecord& contact);
    /// Is a contact at a corner where a face is covered?
    bool isCovered(ContactIndex contact, const Manifold& manifold) const;
    /// Appends the noted contacts that are. Call it when all contacts have been noted and marked.
    void findCovered(const ContactGraph& graph, std::vector<ContactIndex>& covered);

private:
    struct Noted {
        ContactIndex contact = none;
        BodyIndex a = noBody, b = noBody;  ///< its loose bodies
        int sides = 0;                     ///< the bodies that may be part of a floor
        std::int32_t* open = nullptr;      ///< in KeptLanes
    };

    bool mayCover(BodyIndex a, BodyIndex b, bool atCorner) const;
    void mark(BodyIndex a, BodyIndex b);
    void markBoxes(const ContactGraph& graph);
    bool hasMoved(const Noted& noted) const;

    const ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    double dt_;
    std::vector<Noted> noted_;
    std::vector<std::uint8_t> moved_;  ///< by body; empty: none
};

}  // namespace plumb
