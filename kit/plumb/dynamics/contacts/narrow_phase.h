// SPDX-License-Identifier: MIT
// Where do shapes that are near each other touch, and which data of that does the solver need?
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/contacts/floors/corner_watch.h>
#include <plumb/dynamics/contacts/pair_collider.h>
#include <plumb/dynamics/contacts/touch_events.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// A body that comes nearer than this to a sleeping body, or may do so in this step, wakes it [m]. It is above the
/// jitter of what rests; with the whole contactMargin, what only passes by would wake sleepers, too. Test: "a ball put
/// to sleep 5 mm above a plate that slides by sleeps on, and is carried up when the plate rises"
inline constexpr float wakeDistance = 5e-4f;

/// Computes all manifolds of a step: for contacts in the solver's slots batch by batch, which also prepares them for
/// the step, and for the near contacts. A contact that begins to touch gets a slot; one that has parted loses its slot.
///
/// Call in this order: collideSolved(); then collideNear() until isDone(), and after each call wake the sleeping bodies
/// that it returns, which makes their contacts near, too; then finish().
class NarrowPhase {
public:
    /// lanes: as in SolverSettings.
    NarrowPhase(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, const Space& space, int lanes,
                double dt);

    /// Collides the contacts in the solver, and removes near contacts whose bounds do not overlap any more.
    void collideSolved();
    /// Have all near contacts been collided?
    bool isDone() const;
    /// Collides the next batch of near contacts. Returns the sleeping bodies that are touched; the caller must wake
    /// them before the next call.
    std::span<const BodyIndex> collideNear();
    /// Moves contacts into and out of the solver's slots.
    void finish();

    /// Touches that ended because their contacts were removed.
    const StepList<TouchEnd>& ends() const { return ends_; }

private:
    /// Contacts that begin to touch, with their manifolds.
    struct Arrivals {
        FreshLanes fresh;
        ContactIndex contacts[batchLanes];
        std::size_t count = 0;
    };

    void collideColour(std::size_t index, FreshLanes& fresh);
    void prepare(ContactBatch& batch, ManifoldLanes& manifolds, const FreshLanes& fresh, std::size_t used,
                 double ratio) const;
    bool boundsOverlap(ProxyId a, ProxyId b, ContactIndex contact) const;
    void drop(ContactIndex contact);
    void removeParted(NearPairs& near);
    bool mayArrive(ContactIndex contact, const FreshLanes& fresh, std::size_t lane);
    void addArrival(ContactIndex contact, const FreshLanes& fresh, std::size_t lane);
    void sortArrivals();
    void noteSleepers(const ShapePair& pair, const FreshLanes& fresh, std::size_t lane);
    void addToSolver(Arrivals& arrivals);
    void removeFromSolver(ContactIndex contact);

    ContactGraph& graph_;
    ContactStore& contacts_;
    BodyStore& bodies_;
    const Space& space_;
    PairCollider pairs_;
    CornerWatch corners_;
    int lanes_;
    double dt_;
    std::size_t boxesDone_ = 0, othersDone_ = 0;  ///< number of near contacts that are collided
    StepList<ContactIndex> parted_;
    StepList<Arrivals> arrivals_;
    StepList<BodyIndex> sleepers_;
    StepList<TouchEnd> ends_;
};

}  // namespace plumb
