// SPDX-License-Identifier: MIT
// Which contacts in the solver have come to a joint of a floor of several shapes?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/floors/flush_sides.h>
#include <plumb/dynamics/contacts/pair_collider.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

class CornerWatch {
public:
    CornerWatch(const ContactStore& contacts, const BodyStore& bodies, const Space& space, double dt);

    /// Notes the contacts at corners in a batch of the solver, which has just been prepared. kept: of the batch, or
    /// null if manifolds are not kept.
    void note(const PairBatch& batch, const ContactBatch& prepared, KeptLanes* kept, const FreshLanes& fresh);
    /// Takes account of a contact that comes into the solver in this step.
    void noteArrival(ContactIndex contact, const FreshLanes& fresh, std::size_t lane);
    /// Is a contact that is not in the solver yet at a corner where a face is covered?
    bool isCovered(ContactIndex contact, const Manifold& manifold) const;
    /// Appends the noted contacts that are. Call it when all contacts in the solver have been noted and prepared.
    void findCovered(ContactGraph& graph, StepList<ContactIndex>& covered);

private:
    struct Noted {
        ContactIndex contact = none;
        BodyIndex a = noBody, b = noBody;
        int sides = 0;              ///< the bodies that may be part of a floor
        Vec2f normal{0, 0};         ///< in the world
        Manifold manifold;          ///< without features
        KeptLanes* kept = nullptr;  ///< null if the manifold is not kept
        std::size_t lane = 0;
    };

    struct Arrival {
        BodyIndex a = noBody, b = noBody;
        Vec2f normal{0, 0};  ///< in the world
    };

    CornerFaces facesOf(const Noted& noted) const;
    int sidesToAsk(const Noted& noted) const;
    bool isCovered(const Noted& noted) const;

    const ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    double dt_;
    StepList<Noted> noted_;
    StepList<Arrival> arrivals_;  ///< of two points
    FlushSides flush_;
};

}  // namespace plumb
