// SPDX-License-Identifier: MIT
// Where do the shapes of a batch of pairs touch, or may touch in this step?
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/lanes/lane_collider.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The pairs of a batch and their contacts.
struct PairBatch {
    const PairLanes& pairs;
    const ContactIndex* contacts;  ///< of the lanes in use, which are the first ones
    std::size_t count;             ///< number of lanes in use
};

/// Computes manifolds batch by batch. Pairs that are near each other, but may meet only later in the step, get the
/// manifold that they are predicted to have then.
class PairCollider {
public:
    /// lanes: as in SolverSettings.
    PairCollider(ContactStore& contacts, const BodyStore& bodies, const Space& space, int lanes, double dt);

    void collideBoxes(const PairBatch& batch, FreshLanes& fresh) const;
    /// Pairs that are not in the solver, of which most are apart.
    void collideNear(const PairBatch& batch, FreshLanes& fresh) const;
    /// Contacts in the solver. Manifolds that are still right are used again.
    void collideSolved(const PairBatch& batch, const ManifoldLanes& manifolds, KeptLanes& kept,
                       FreshLanes& fresh) const;

    /// In a world that wraps, sets the distances between bodies whose contact is with a periodic image. Does nothing in
    /// other worlds.
    void setPeriodicOffsets(const ContactIndex* contacts, std::size_t count, FreshLanes& fresh) const;
    /// How far the bodies may move relative to each other in the step, plus the contact margin [m].
    float marginOf(const ShapePair& pair) const;

private:
    using Wanted = Lanes<std::int32_t>;  ///< not 0: the lane is to be collided

    const LaneCollider& colliderFor(const PairBatch& batch) const;
    bool collideDiscsOnly(const PairBatch& batch, FreshLanes& fresh) const;
    void collideLanes(const PairBatch& batch, const Wanted& wanted, FreshLanes& fresh) const;
    void resolveUncertain(const PairBatch& batch, FreshLanes& fresh) const;
    void collideOne(const PairBatch& batch, std::size_t lane, FreshLanes& fresh) const;
    ShapePair pairOf(const PairBatch& batch, std::size_t lane) const;
    Manifold predict(ContactIndex contact, const ShapePair& pair) const;
    bool mayMeetSpinning(const PairBatch& batch, std::size_t lane, const FreshLanes& fresh) const;
    bool spins(const ShapePair& pair) const;

    ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    int lanes_;
    double dt_;
    CornerTable corners_;
};

}  // namespace plumb
