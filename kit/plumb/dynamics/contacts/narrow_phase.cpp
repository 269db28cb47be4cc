// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/narrow_phase.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/contacts/flush_faces.h>
#include <plumb/dynamics/contacts/initial_impulses.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/vec2.h>

namespace plumb {

namespace {

float nearestOf(const Manifold& m) {
    return m.count > 1 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

/// How far two bodies may move relative to each other in the step.
struct Approach {
    float margin = 0;   ///< in any direction, plus the contact margin [m]
    float turn = 0;     ///< the part of margin that is due to rotation [m]
    Vec2f shift{0, 0};  ///< displacement of B relative to A, in A's frame [m]
};

Approach approachOf(const BodyStore& bodies, const ShapePair& pair) {
    const BodyPlace& a = bodies.place[pair.bodyA];
    const BodyPlace& b = bodies.place[pair.bodyB];
    const float x = b.shiftX - a.shiftX, y = b.shiftY - a.shiftY;
    const float turn = a.turn + b.turn;
    return {std::sqrt(x * x + y * y) + turn + contactMargin, turn, {a.cos * x + a.sin * y, a.cos * y - a.sin * x}};
}

bool isUncertain(const FreshLanes& fresh) {
    return std::any_of(std::begin(fresh.uncertain), std::end(fresh.uncertain), [](std::int32_t u) { return u != 0; });
}

Manifold manifoldAt(const FreshLanes& fresh, std::size_t lane) {
    Manifold manifold;
    manifold.normal = {fresh.normalX[lane], fresh.normalY[lane]};
    manifold.count = fresh.count[lane];
    for (std::size_t p = 0; p < 2; ++p) {
        const FreshPoint& point = fresh.points[p];
        manifold.points[p] = {{point.x[lane], point.y[lane]}, point.separation[lane], 0};
    }
    return manifold;
}

}  // namespace

NarrowPhase::NarrowPhase(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, const Space& space, int lanes,
                         double dt)
    : graph_(graph),
      contacts_(contacts),
      bodies_(bodies),
      space_(space),
      collider_(laneCollider(lanes)),
      lanes_(lanes),
      dt_(dt) {}

void NarrowPhase::collideSolved() {
    contacts_.predicted.clear();
    for (std::size_t index = 0; index < graph_.colours.size(); ++index) collideColour(index);
    const std::vector<ContactIndex> through = findLetThrough(contacts_, graph_, bodies_, space_);
    parted_.insert(parted_.end(), through.begin(), through.end());
    removeParted(contacts_.nearBoxes);
    removeParted(contacts_.nearOthers);
    for (const ContactIndex index : contacts_.watched) contacts_[index].met = false;
    for (const ContactIndex index : contacts_.withVerdict) contacts_[index].met = false;
}

bool NarrowPhase::isDone() const {
    return boxesDone_ == contacts_.nearBoxes.contactOf.size() && othersDone_ == contacts_.nearOthers.contactOf.size();
}

std::span<const BodyIndex> NarrowPhase::collideNear() {
    const bool isBoxes = boxesDone_ < contacts_.nearBoxes.contactOf.size();
    const NearPairs& near = isBoxes ? contacts_.nearBoxes : contacts_.nearOthers;
    std::size_t& done = isBoxes ? boxesDone_ : othersDone_;
    const std::size_t start = done, first = start - start % batchLanes;
    const std::size_t count = std::min<std::size_t>(batchLanes, near.contactOf.size() - first);
    done = first + count;
    const Batch batch{near.lanes[first / batchLanes], near.contactOf.data() + first, count};
    FreshLanes fresh;
    if (isBoxes)
        collideBoxes(batch, fresh);
    else
        collideOthers(batch, fresh);
    sleepers_.clear();
    for (std::size_t lane = start - first; lane < count; ++lane) {
        if (fresh.count[lane] == 0) continue;
        const ContactIndex index = batch.contacts[lane];
        if (!mayArrive(index, batch.pairs, fresh, lane)) continue;
        addArrival(index, fresh, lane);
        noteSleepers(pairAt(batch.pairs, lane), fresh, lane);
    }
    return sleepers_;
}

void NarrowPhase::finish() {
    for (const ContactIndex index : contacts_.watched)
        if (!contacts_[index].met) contacts_[index].manifold.count = 0;
    dropVerdicts(contacts_, graph_);
    for (const ContactIndex index : parted_) removeFromSolver(index);
    sortArrivals();
    for (Arrivals& some : arrivals_) addToSolver(some);
}

void NarrowPhase::collideColour(std::size_t index) {
    Colour& colour = graph_.colours[index];
    FreshLanes fresh;
    for (std::size_t b = 0; b < colour.batches.size(); ++b) {
        const std::size_t first = b * batchLanes;
        const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - first);
        const Batch batch{colour.pairs[b], colour.contactOf.data() + first, count};
        if (index % 2 == 0)
            collideBoxes(batch, fresh);
        else
            collideOthers(batch, fresh);
        dropCovered(batch, fresh);
        prepare(colour.batches[b], colour.manifolds[b], fresh);
        for (std::size_t lane = 0; lane < count; ++lane)
            if (fresh.count[lane] == 0) parted_.push_back(batch.contacts[lane]);
    }
}

/// Takes away the points of contacts that have come to a joint of a floor of several shapes.
void NarrowPhase::dropCovered(const Batch& batch, FreshLanes& fresh) const {
    if (!someAtCorner(fresh)) return;
    for (std::size_t lane = 0; lane < batch.count; ++lane)
        if (isAtCorner(fresh, lane) && isAtCoveredFace(contacts_, bodies_, space_, batch.contacts[lane],
                                                       pairAt(batch.pairs, lane), fresh, lane, dt_))
            fresh.count[lane] = 0;
}

void NarrowPhase::collideBoxes(const Batch& batch, FreshLanes& fresh) const {
    setPeriodicOffsets(batch.contacts, batch.count, fresh);
    collider_.collideBoxes(batch.pairs, bodies_.place.data(), fresh);
    resolveUncertain(batch, fresh);
}

/// Collides lanes with discs all at once, and lanes with other shapes one by one; lanes from count on get no points.
void NarrowPhase::collideOthers(const Batch& batch, FreshLanes& fresh) const {
    const std::size_t count = batch.count;
    setPeriodicOffsets(batch.contacts, count, fresh);
    const auto& isDisc = batch.pairs.discs;
    const auto discs = count - static_cast<std::size_t>(std::count(isDisc, isDisc + count, noDisc));
    FreshLanes round;
    if (fresh.around) round = fresh;
    if (discs > 0) collider_.collideDiscs(batch.pairs, bodies_.place.data(), discs == count ? fresh : round);
    if (discs < count) collideAny(batch, fresh);
    for (std::size_t lane = 0; discs > 0 && discs < count && lane < count; ++lane)
        if (isDisc[lane] != noDisc) copyLane(fresh, lane, round, lane, freshRows);
    for (std::size_t lane = count; lane < batchLanes; ++lane) setFresh(fresh, lane, {});
    resolveUncertain(batch, fresh);
}

/// The bounding boxes of all lanes are collided at once: pairs whose boxes cannot meet in this step are done. The
/// others are collided one by one.
void NarrowPhase::collideAny(const Batch& batch, FreshLanes& fresh) const {
    collider_.collideBoxes(batch.pairs, bodies_.place.data(), fresh);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        fresh.uncertain[lane] = 0;
        if (batch.pairs.discs[lane] == noDisc && fresh.count[lane] > 0)
            setFresh(fresh, lane, manifoldOf(batch.contacts[lane], pairOf(batch, lane)));
    }
}

/// Computes the predicted manifold for the lanes in which it is uncertain whether and how the shapes meet.
void NarrowPhase::resolveUncertain(const Batch& batch, FreshLanes& fresh) const {
    if (!isUncertain(fresh)) return;
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        if (fresh.uncertain[lane] == 0) continue;
        const ShapePair pair = pairOf(batch, lane);
        setFresh(fresh, lane, predict(batch.contacts[lane], pair, approachOf(bodies_, pair).margin));
    }
}

/// In a world that wraps, sets the distances between bodies whose contact is with a periodic image. Does nothing in
/// other worlds.
void NarrowPhase::setPeriodicOffsets(const ContactIndex* contacts, std::size_t count, FreshLanes& fresh) const {
    fresh.around = false;
    if (!bodies_.wrap.any()) return;
    for (std::size_t lane = 0; lane < count; ++lane)
        fresh.around = fresh.around || !contacts_[contacts[lane]].shift.isZero(0);
    if (!fresh.around) return;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        Vec2 apart(0, 0);
        if (lane < count) {
            const ContactRecord& contact = contacts_[contacts[lane]];
            const Vec2 b = bodies_.motion[contact.bodyB].center + contact.shift;
            apart = b - bodies_.motion[contact.bodyA].center;
        }
        fresh.apartX[lane] = static_cast<float>(apart.x());
        fresh.apartY[lane] = static_cast<float>(apart.y());
    }
}

void NarrowPhase::prepare(ContactBatch& batch, ManifoldLanes& manifolds, const FreshLanes& fresh) const {
    collider_.prepare(batch, manifolds, bodies_.place.data(), bodies_.velocity.data(), fresh,
                      static_cast<float>(1 / dt_));
}

ShapePair NarrowPhase::pairOf(const Batch& batch, std::size_t lane) const {
    ShapePair pair = pairAt(batch.pairs, lane);
    if (!bodies_.wrap.any()) return pair;
    pair.shiftX = contacts_[batch.contacts[lane]].shift.x();
    pair.shiftY = contacts_[batch.contacts[lane]].shift.y();
    return pair;
}

/// The manifold of any two shapes. It is empty if they cannot meet along their normal in this step. Two that spin are
/// predicted even if they are near each other, unless they touch.
Manifold NarrowPhase::manifoldOf(ContactIndex index, const ShapePair& pair) const {
    const Approach approach = approachOf(bodies_, pair);
    const BodyMotion b = shifted(bodies_.motion[pair.bodyB], {pair.shiftX, pair.shiftY});
    const RelativePose pose = relativePose(bodies_.motion[pair.bodyA], b);
    const Manifold m = manifold(space_[pair.proxyA].convex, space_[pair.proxyB].convex, pose, approach.margin);
    if (m.count == 0) return m;
    if (nearestOf(m) <= contactMargin) {
        if (!isApart(index, m) || !spins(pair)) return m;
        const Manifold met = predict(index, pair, approach.margin);
        return met.count > 0 ? met : m;
    }
    const float closing = approach.turn - approach.shift.dot(m.normal);
    return nearestOf(m) > closing ? Manifold{} : predict(index, pair, approach.margin);
}

/// The predicted manifold. Of bodies that spin, the contact is noted.
Manifold NarrowPhase::predict(ContactIndex index, const ShapePair& pair, float margin) const {
    const Manifold m = predictedManifold(bodies_, space_, pair, margin, dt_);
    if (m.count > 0 && spins(pair)) contacts_.predicted.push_back(index);
    return m;
}

bool NarrowPhase::isApart(ContactIndex index, const Manifold& m) const {
    return !contacts_[index].touching && nearestOf(m) > 0;
}

/// Two dynamic bodies, one of which spins.
bool NarrowPhase::spins(const ShapePair& pair) const {
    const auto turns = [this](BodyIndex body) {
        return std::fabs(bodies_.motion[body].angularVelocity) * dt_ > spinningTurn;
    };
    const bool both = bodies_.isDynamic(pair.bodyA) && bodies_.isDynamic(pair.bodyB);
    return both && (turns(pair.bodyA) || turns(pair.bodyB));
}

/// Removes contacts whose bounds do not overlap any more.
void NarrowPhase::removeParted(NearPairs& near) {
    const bool wraps = bodies_.wrap.any();
    const auto overlap = [&](std::size_t slot) {
        const PairLanes& pairs = near.lanes[slot / batchLanes];
        const ProxyId a = pairs.proxyA[slot % batchLanes], b = pairs.proxyB[slot % batchLanes];
        return wraps ? space_.boxesOverlap(a, b, contacts_[near.contactOf[slot]].shift) : space_.boxesOverlap(a, b);
    };
    for (std::size_t slot = 0; slot < near.contactOf.size();) {
        if (overlap(slot)) {
            ++slot;
            continue;
        }
        const ContactIndex index = near.contactOf[slot];
        const ContactRecord& contact = contacts_[index];
        if (contact.touching) ends_.push_back({contact.proxyA, contact.proxyB});
        removeContact(graph_, contacts_, bodies_, index);
    }
}

/// May a near contact enter the solver? Not if it is at a joint of a floor of several shapes, or if a rule or a one-way
/// side lets its shapes pass through each other.
bool NarrowPhase::mayArrive(ContactIndex index, const PairLanes& pairs, const FreshLanes& fresh, std::size_t lane) {
    ContactRecord& contact = contacts_[index];
    contact.met = true;
    const bool covered = isAtCorner(fresh, lane) &&
                         isAtCoveredFace(contacts_, bodies_, space_, index, pairAt(pairs, lane), fresh, lane, dt_);
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
        bool operator<(const Place& other) const { return boxes != other.boxes ? boxes : shapes < other.shapes; }
    };
    std::vector<Place> order;
    for (std::size_t batch = 0; batch < arrivals_.size(); ++batch)
        for (std::size_t lane = 0; lane < arrivals_[batch].count; ++lane) {
            const ContactRecord& c = contacts_[arrivals_[batch].contacts[lane]];
            order.push_back({c.boxes, shapesOf(c), batch, lane});
        }
    if (std::is_sorted(order.begin(), order.end())) return;
    std::sort(order.begin(), order.end());
    const std::vector<Arrivals> found = std::exchange(arrivals_, {});
    for (const Place& place : order) {
        const Arrivals& some = found[place.batch];
        addArrival(some.contacts[place.lane], some.fresh, place.lane);
    }
}

void NarrowPhase::noteSleepers(const ShapePair& pair, const FreshLanes& fresh, std::size_t lane) {
    float nearest = fresh.points[0].separation[lane];
    if (fresh.count[lane] > 1) nearest = std::min(nearest, fresh.points[1].separation[lane]);
    if (nearest > approachOf(bodies_, pair).margin - (contactMargin - wakeDistance)) return;
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
    setPeriodicOffsets(arrivals.contacts, arrivals.count, arrivals.fresh);
    prepare(batch, manifolds, arrivals.fresh);
    guessImpulses(batch, bodies_, lanes_);
    for (std::size_t lane = 0; lane < arrivals.count; ++lane) {
        const ContactIndex index = arrivals.contacts[lane];
        graph_.add(bodies_, contacts_, index, batch, manifolds, lane);
        if (areBodiesReady(bodies_, contacts_[index])) continue;
        graph_.remove(bodies_, contacts_, index);
        contacts_.addNear(index);
    }
}

/// Moves a contact that has parted back to the near contacts, and clears its impulses.
void NarrowPhase::removeFromSolver(ContactIndex index) {
    ContactRecord& contact = contacts_[index];
    graph_.remove(bodies_, contacts_, index);
    contacts_.addNear(index);
    contact.manifold.count = 0;
    contact.memory = {};
    contact.rollImpulse = 0;
}

}  // namespace plumb
