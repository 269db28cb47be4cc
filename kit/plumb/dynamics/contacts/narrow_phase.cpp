// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/narrow_phase.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/contacts/floors/flush_faces.h>
#include <plumb/dynamics/contacts/overlaps.h>
#include <plumb/math/detail/for_lanes.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

NarrowPhase::NarrowPhase(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, const Space& space, int lanes,
                         double dt)
    : graph_(graph),
      contacts_(contacts),
      bodies_(bodies),
      space_(space),
      pairs_(contacts, bodies, space, lanes, dt),
      corners_(contacts, bodies, space, dt),
      lanes_(lanes),
      dt_(dt) {}

/// First what is in the solver, as its slots do not move in the meantime: what has parted is only noted, and goes in
/// finish().
void NarrowPhase::collideSolved() {
    contacts_.predicted.clear();
    FreshLanes fresh{};  // lanes that are not in use are prepared, too: they must be finite
    for (std::size_t index = 0; index < graph_.colours.size(); ++index) collideColour(index, fresh);
    const StepList<ContactIndex> through = findLetThrough(contacts_, graph_, bodies_, space_);
    parted_.insert(parted_.end(), through.begin(), through.end());
    removeParted(contacts_.nearBoxes);
    removeParted(contacts_.nearOthers);
    // mayArrive sets met where a contact has a manifold in this step. Where it is still false at the end, the two have
    // parted.
    for (const ContactIndex index : contacts_.watched) contacts_[index].met = false;
    for (const ContactIndex index : contacts_.withVerdict) contacts_[index].met = false;
}

bool NarrowPhase::isDone() const {
    return boxesDone_ == contacts_.nearBoxes.contactOf.size() && othersDone_ == contacts_.nearOthers.contactOf.size();
}

/// One batch a call: waking bodies appends their contacts to the lists that are being walked.
std::span<const BodyIndex> NarrowPhase::collideNear() {
    const bool isBoxes = boxesDone_ < contacts_.nearBoxes.contactOf.size();
    const NearPairs& near = isBoxes ? contacts_.nearBoxes : contacts_.nearOthers;
    std::size_t& done = isBoxes ? boxesDone_ : othersDone_;
    // Contacts of bodies that were woken are appended, perhaps to a batch that has been collided already. Then it is
    // collided once more, and only its new lanes count.
    const std::size_t start = done, first = start - start % batchLanes;
    const std::size_t count = std::min<std::size_t>(batchLanes, near.contactOf.size() - first);
    done = first + count;
    const PairBatch batch{near.lanes[first / batchLanes], near.contactOf.data() + first, count};
    FreshLanes fresh;
    if (isBoxes)
        pairs_.collideBoxes(batch, fresh);
    else
        pairs_.collideNear(batch, fresh);
    sleepers_.clear();
    for (std::size_t lane = start - first; lane < count; ++lane) {
        if (fresh.count[lane] == 0) continue;
        const ContactIndex index = batch.contacts[lane];
        if (!mayArrive(index, fresh, lane)) continue;
        corners_.noteArrival(index, fresh, lane);
        addArrival(index, fresh, lane);
        noteSleepers(pairAt(batch.pairs, lane), fresh, lane);
    }
    return sleepers_;
}

/// The order matters. Verdicts are dropped by what the slots hold now; covered corners need all manifolds of the step;
/// what has parted frees its colours before others arrive; and overlaps are measured in the slots where contacts stay.
void NarrowPhase::finish() {
    for (const ContactIndex index : contacts_.watched)
        if (!contacts_[index].met) contacts_[index].manifold.count = 0;
    dropVerdicts(contacts_, graph_);
    corners_.findCovered(graph_, parted_);
    for (const ContactIndex index : parted_) removeFromSolver(index);
    sortArrivals();
    for (Arrivals& some : arrivals_) addToSolver(some);
    measureOverlaps(contacts_, graph_, bodies_);
}

/// fresh: scratch, one for all batches, so that it stays in the cache.
void NarrowPhase::collideColour(std::size_t index, FreshLanes& fresh) {
    Colour& colour = graph_.colours[index];
    for (std::size_t b = 0; b < colour.batches.size(); ++b) {
        const std::size_t first = b * batchLanes;
        const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - first);
        const PairBatch batch{colour.pairs[b], colour.contactOf.data() + first, count};
        if (isOfBoxes(index))
            pairs_.collideBoxes(batch, fresh);
        else
            pairs_.collideSolved(batch, colour.manifolds[b], colour.kept[b], fresh);
        // Impacts read all lanes of a batch: one that is not in use must have no points.
        std::fill(fresh.count + count, std::end(fresh.count), 0);
        prepare(colour.batches[b], colour.manifolds[b], fresh, count, bodies_.stepRatio);
        // While the batch is in the cache. Whether a face is covered is asked later, when all contacts are known.
        corners_.note(batch, colour.batches[b], isOfBoxes(index) ? nullptr : &colour.kept[b], fresh);
        for (std::size_t lane = 0; lane < count; ++lane)
            if (fresh.count[lane] == 0) parted_.push_back(batch.contacts[lane]);
    }
}

void NarrowPhase::prepare(ContactBatch& batch, ManifoldLanes& manifolds, const FreshLanes& fresh, std::size_t used,
                          double ratio) const {
    const StepLength step{static_cast<float>(1 / dt_), static_cast<float>(ratio), 2 * bodies_.subSteps};
    laneCollider(lanesFor(used, lanes_))
        .prepare(batch, manifolds, bodies_.place.data(), bodies_.velocity.data(), fresh, step, used);
}

/// The shift is in the contact's record, which only a world that wraps need read.
bool NarrowPhase::boundsOverlap(ProxyId a, ProxyId b, ContactIndex index) const {
    return bodies_.wrap.any() ? space_.boxesOverlap(a, b, contacts_[index].shift) : space_.boxesOverlap(a, b);
}

/// A contact that goes with its bounds can report no end later: the end is noted here.
void NarrowPhase::drop(ContactIndex index) {
    const ContactRecord& contact = contacts_[index];
    if (contact.touching) ends_.push_back({contact.proxyA, contact.proxyB});
    removeContact(graph_, contacts_, bodies_, index);
}

/// Removes contacts whose bounds do not overlap any more, one by one: O(near contacts). When their bounds meet again,
/// the space reports the pair as new.
void NarrowPhase::removeParted(NearPairs& near) {
    for (std::size_t slot = 0; slot < near.contactOf.size();) {
        const PairLanes& pairs = near.lanes[slot / batchLanes];
        const std::size_t lane = slot % batchLanes;
        if (boundsOverlap(pairs.proxyA[lane], pairs.proxyB[lane], near.contactOf[slot]))
            ++slot;
        else
            drop(near.contactOf[slot]);
    }
}

/// May a near contact enter the solver? Not if it is at a joint of a floor of several shapes, or if a rule or a one-way
/// side lets its shapes pass through each other.
bool NarrowPhase::mayArrive(ContactIndex index, const FreshLanes& fresh, std::size_t lane) {
    ContactRecord& contact = contacts_[index];
    contact.met = true;
    const bool covered = isAtCorner(fresh, lane) && corners_.isCovered(index, manifoldAt(fresh, lane));
    if (!covered && !contact.ruled) return true;
    if (!covered && isSolid(contacts_, bodies_, space_, index, faceOf(bodies_, contact, manifoldAt(fresh, lane))))
        return true;
    contact.manifold.count = 0;
    return false;
}

void NarrowPhase::addArrival(ContactIndex index, const FreshLanes& fresh, std::size_t lane) {
    if (arrivals_.empty() || arrivals_.back().count == batchLanes) arrivals_.emplace_back();
    Arrivals& last = arrivals_.back();
    last.contacts[last.count] = index;
    copyLane(last.fresh, last.count, fresh, lane, freshRows);
    ++last.count;
}

/// Puts the arrivals in the order of their shapes: boxes first, then by proxies. They were found in the order of the
/// near contacts, which changes with each that goes, also far away, and would change the colours that they get.
void NarrowPhase::sortArrivals() {
    struct Place {
        bool boxes;
        std::tuple<ProxyId, ProxyId, double, double> shapes;
        std::size_t batch, lane;
    };
    StepList<Place> order;
    for (std::size_t batch = 0; batch < arrivals_.size(); ++batch)
        for (std::size_t lane = 0; lane < arrivals_[batch].count; ++lane) {
            const ContactRecord& c = contacts_[arrivals_[batch].contacts[lane]];
            order.push_back({c.boxes, shapesOf(c), batch, lane});
        }
    if (!sortBy(order, [](const Place& place) { return std::tuple(!place.boxes, place.shapes); })) return;
    const StepList<Arrivals> found = std::exchange(arrivals_, {});
    for (const Place& place : order) {
        const Arrivals& some = found[place.batch];
        addArrival(some.contacts[place.lane], some.fresh, place.lane);
    }
}

/// A sleeper wakes if the two may come nearer than wakeDistance in this step: the margin is the contact margin and how
/// far they may move. Without that, it would be hit as if it could not move.
void NarrowPhase::noteSleepers(const ShapePair& pair, const FreshLanes& fresh, std::size_t lane) {
    if (nearestOf(fresh, lane) > pairs_.marginOf(pair) - (contactMargin - wakeDistance)) return;
    for (const BodyIndex body : {pair.bodyA, pair.bodyB})
        if (bodies_.isDynamic(body) && !bodies_.record[body].awake) sleepers_.push_back(body);
}

/// Moves new contacts into slots of the solver. Contacts that cannot act in this step go back to the near ones, with
/// their data in their records.
void NarrowPhase::addToSolver(Arrivals& arrivals) {
    ContactBatch batch{};
    ManifoldLanes manifolds{};
    for (std::size_t lane = 0; lane < arrivals.count; ++lane)
        fillLane(batch, manifolds, lane, contacts_[arrivals.contacts[lane]], bodies_, space_);
    pairs_.setPeriodicOffsets(arrivals.contacts, arrivals.count, arrivals.fresh);
    // Ratio 1: fillLane has scaled the impulses, as each contact has its own time since it was solved.
    prepare(batch, manifolds, arrivals.fresh, arrivals.count, 1);
    guessImpulses(batch, bodies_, lanes_);
    for (std::size_t lane = 0; lane < arrivals.count; ++lane) {
        const ContactIndex index = arrivals.contacts[lane];
        graph_.add(bodies_, contacts_, index, batch, manifolds, lane);
        if (areBodiesReady(bodies_, contacts_[index])) continue;
        graph_.remove(bodies_, contacts_, index);
        contacts_.addNear(index);
    }
}

/// Moves a contact that has parted back to the near contacts, and clears its impulses. If even the bounds are apart,
/// after a jump, it goes at once: they may meet again before the next time, and the pair would be found twice.
void NarrowPhase::removeFromSolver(ContactIndex index) {
    ContactRecord& contact = contacts_[index];
    graph_.remove(bodies_, contacts_, index);
    contacts_.addNear(index);
    contact.manifold.count = 0;
    contact.memory = {};
    contact.rollImpulse = 0;
    if (!boundsOverlap(contact.proxyA, contact.proxyB, index)) drop(index);
}

}  // namespace plumb
