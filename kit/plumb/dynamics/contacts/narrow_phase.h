// SPDX-License-Identifier: MIT
// Where do shapes touch that are near each other, and what does the solver need to know of it?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/space/space.h>

namespace plumb {

/// Makes all manifolds of a step anew: of contacts in the solver's slots batch by batch, where they are prepared for
/// the step, and of the others near each other. What comes to touch gets a slot, what has parted loses it.
///
/// In this order: collideSolved(); collideNear() until isDone(), each time waking the sleepers that it names, whose
/// contacts are then near as well; finish().
class NarrowPhase {
public:
    /// lanes: of the solver (see SolverSettings).
    NarrowPhase(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, const Space& space, int lanes,
                double dt);

    /// What the solver has; and takes out near contacts whose bounds have parted.
    void collideSolved();
    bool isDone() const;
    /// The next batch of near contacts. Returns the sleepers that it touches, which are to be woken now.
    std::span<const BodyIndex> collideNear();
    void finish();

    /// Of contacts that were taken out.
    const std::vector<TouchEnd>& ends() const { return ends_; }

private:
    /// Contacts of a batch's lanes.
    struct Batch {
        const PairLanes& pairs;
        const ContactIndex* contacts;  ///< of the first lanes
        std::size_t count;             ///< of lanes in use
    };
    /// What has come to touch, and where.
    struct Arrivals {
        FreshLanes fresh;
        ContactIndex contacts[batchLanes];
        std::size_t count = 0;
    };

    void collideColour(std::size_t index);
    void collideBoxes(const Batch& batch, FreshLanes& fresh) const;
    void collideOthers(const Batch& batch, FreshLanes& fresh) const;
    void collideAny(const Batch& batch, FreshLanes& fresh) const;
    void resolveUncertain(const Batch& batch, FreshLanes& fresh) const;
    void setPeriodicOffsets(const ContactIndex* contacts, std::size_t count, FreshLanes& fresh) const;
    void prepare(ContactBatch& batch, ManifoldLanes& manifolds, const FreshLanes& fresh) const;
    ShapePair pairOf(const Batch& batch, std::size_t lane) const;
    Manifold manifoldOf(const ShapePair& pair) const;
    void removeParted(NearPairs& near);
    bool mayArrive(ContactIndex contact, const FreshLanes& fresh, std::size_t lane);
    void addArrival(ContactIndex contact, const FreshLanes& fresh, std::size_t lane);
    void noteSleepers(const ShapePair& pair, const FreshLanes& fresh, std::size_t lane);
    void addToSolver(Arrivals& arrivals);
    void removeFromSolver(ContactIndex contact);

    ContactGraph& graph_;
    ContactStore& contacts_;
    BodyStore& bodies_;
    const Space& space_;
    const LaneCollider& collider_;
    int lanes_;
    double dt_;
    std::size_t boxesDone_ = 0, othersDone_ = 0;  ///< of the near contacts
    std::vector<ContactIndex> parted_;
    std::vector<Arrivals> arrivals_;
    std::vector<BodyIndex> sleepers_;
    std::vector<TouchEnd> ends_;
};

}  // namespace plumb
