// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/narrow_phase.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/contact_rules.h>
#include <plumb/dynamics/detail/first_impulses.h>
#include <plumb/dynamics/detail/foresee.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/lane_collider.h>
#include <plumb/dynamics/detail/lanes.h>
#include <plumb/math/vec2f.h>

namespace plumb {

namespace {

/// What comes nearer than this to a sleeper, or may in the step, wakes it [m].
constexpr float trembling = 5e-4f;

float nearestOf(const Manifold& m) {
    return m.count > 1 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

/// How far two bodies may move against each other in the step.
struct Approach {
    float margin = 0;   ///< any way, and the contact margin [m]
    float turn = 0;     ///< part of it, by turning [m]
    Vec2f shift{0, 0};  ///< of B against A, in A's frame [m]
};

Approach approachOf(const WorldState& world, const ShapePair& pair) {
    const BodyPlace& a = world.bodies.place[pair.bodyA];
    const BodyPlace& b = world.bodies.place[pair.bodyB];
    const float x = b.shiftX - a.shiftX, y = b.shiftY - a.shiftY;
    const float turn = a.turn + b.turn;
    return {std::sqrt(x * x + y * y) + turn + contactMargin, turn, {a.cos * x + a.sin * y, a.cos * y - a.sin * x}};
}

/// Of any two shapes. Those that cannot come together along their normal in this step will not touch in it.
Manifold manifoldOf(const WorldState& world, const ShapePair& pair, double dt) {
    const Approach approach = approachOf(world, pair);
    const BodyMotion b = shifted(world.bodies.motion[pair.bodyB], {pair.shiftX, pair.shiftY});
    const RelativePose pose = relativePose(world.bodies.motion[pair.bodyA], b);
    const Manifold m =
        manifold(world.space[pair.proxyA].convex, world.space[pair.proxyB].convex, pose, approach.margin);
    if (m.count == 0 || nearestOf(m) <= contactMargin) return m;
    const float closing = approach.turn - approach.shift.dot(m.normal);
    return nearestOf(m) > closing ? Manifold{} : foreseen(world, pair, approach.margin, dt);
}

/// Contacts of lanes, whose shapes may meet around the world.
using Contacts = const ContactIndex*;

ShapePair pairOf(const WorldState& world, const PairLanes& pairs, Contacts contacts, std::size_t lane) {
    ShapePair pair = pairAt(pairs, lane);
    if (!world.def.wrap.any()) return pair;
    pair.shiftX = world.contacts.contacts[contacts[lane]].shift.x();
    pair.shiftY = world.contacts.contacts[contacts[lane]].shift.y();
    return pair;
}

/// How far apart bodies are that meet around the world, for the lanes. In any other world nothing.
void seeAround(const WorldState& world, Contacts contacts, std::size_t count, FreshLanes& fresh) {
    fresh.around = false;
    if (!world.def.wrap.any()) return;
    for (std::size_t lane = 0; lane < count; ++lane)
        fresh.around = fresh.around || !world.contacts.contacts[contacts[lane]].shift.isZero(0);
    if (!fresh.around) return;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        Vec2 apart(0, 0);
        if (lane < count) {
            const ContactRecord& contact = world.contacts.contacts[contacts[lane]];
            const Vec2 b = world.bodies.motion[contact.bodyB].center + contact.shift;
            apart = b - world.bodies.motion[contact.bodyA].center;
        }
        fresh.apartX[lane] = static_cast<float>(apart.x());
        fresh.apartY[lane] = static_cast<float>(apart.y());
    }
}

bool isUncertain(const FreshLanes& fresh) {
    return std::any_of(std::begin(fresh.uncertain), std::end(fresh.uncertain), [](std::int32_t u) { return u != 0; });
}

/// Takes a closer look at the lanes of which outlines alone do not say whether they meet.
void settleUncertain(const WorldState& world, const PairLanes& pairs, Contacts contacts, std::size_t count,
                     FreshLanes& fresh, double dt) {
    if (!isUncertain(fresh)) return;
    for (std::size_t lane = 0; lane < count; ++lane) {
        if (fresh.uncertain[lane] == 0) continue;
        const ShapePair pair = pairOf(world, pairs, contacts, lane);
        setFresh(fresh, lane, foreseen(world, pair, approachOf(world, pair).margin, dt));
    }
}

void collideBoxes(const WorldState& world, const PairLanes& pairs, Contacts contacts, std::size_t count,
                  FreshLanes& fresh, double dt) {
    seeAround(world, contacts, count, fresh);
    world.collider->collideBoxes(pairs, world.bodies.place.data(), fresh);
    settleUncertain(world, pairs, contacts, count, fresh, dt);
}

/// Those whose boxes cannot come together in this step all at once; the rest one by one.
void collideAny(const WorldState& world, const PairLanes& pairs, Contacts contacts, std::size_t count,
                FreshLanes& fresh, double dt) {
    world.collider->collideBoxes(pairs, world.bodies.place.data(), fresh);
    for (std::size_t lane = 0; lane < count; ++lane) {
        fresh.uncertain[lane] = 0;
        if (pairs.discs[lane] == noDisc && fresh.count[lane] > 0)
            setFresh(fresh, lane, manifoldOf(world, pairOf(world, pairs, contacts, lane), dt));
    }
}

/// Lanes of discs at once, lanes of other shapes by themselves; lanes beyond count get no points.
void collideOthers(const WorldState& world, const PairLanes& pairs, Contacts contacts, std::size_t count,
                   FreshLanes& fresh, double dt) {
    seeAround(world, contacts, count, fresh);
    const auto discs = count - static_cast<std::size_t>(std::count(pairs.discs, pairs.discs + count, noDisc));
    FreshLanes round;
    if (fresh.around) round = fresh;
    if (discs > 0) world.collider->collideDiscs(pairs, world.bodies.place.data(), discs == count ? fresh : round);
    if (discs < count) collideAny(world, pairs, contacts, count, fresh, dt);
    for (std::size_t lane = 0; discs > 0 && discs < count && lane < count; ++lane)
        if (pairs.discs[lane] != noDisc) copyLane(fresh, lane, round, lane, freshRows);
    for (std::size_t lane = count; lane < batchLanes; ++lane) setFresh(fresh, lane, {});
    settleUncertain(world, pairs, contacts, count, fresh, dt);
}

void prepareLanes(WorldState& world, ContactBatch& batch, ManifoldLanes& manifolds, const FreshLanes& fresh,
                  double dt) {
    world.collider->prepare(batch, manifolds, world.bodies.place.data(), world.bodies.velocity.data(), fresh,
                            static_cast<float>(1 / dt));
}

void collideColour(WorldState& world, std::size_t index, std::vector<ContactIndex>& parted, double dt) {
    Colour& colour = world.graph.colours[index];
    FreshLanes fresh;
    for (std::size_t b = 0; b < colour.batches.size(); ++b) {
        const std::size_t first = b * batchLanes;
        const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - first);
        const Contacts contacts = colour.contactOf.data() + first;
        if (index % 2 == 0)
            collideBoxes(world, colour.pairs[b], contacts, count, fresh, dt);
        else
            collideOthers(world, colour.pairs[b], contacts, count, fresh, dt);
        prepareLanes(world, colour.batches[b], colour.manifolds[b], fresh, dt);
        for (std::size_t lane = 0; lane < count; ++lane)
            if (fresh.count[lane] == 0) parted.push_back(colour.contactOf[first + lane]);
    }
}

void wakeTouched(WorldState& world, const ShapePair& pair, const FreshLanes& fresh, std::size_t lane) {
    float nearest = fresh.points[0].separation[lane];
    if (fresh.count[lane] > 1) nearest = std::min(nearest, fresh.points[1].separation[lane]);
    if (nearest > approachOf(world, pair).margin - (contactMargin - trembling)) return;
    for (const BodyIndex body : {pair.bodyA, pair.bodyB})
        if (world.bodies.isDynamic(body) && !world.bodies.record[body].awake) wakeIsland(world, body);
}

/// What has come to touch, and where.
struct Arrivals {
    FreshLanes fresh;
    ContactIndex contacts[batchLanes];
    std::size_t count = 0;
};

void addArrival(std::vector<Arrivals>& arrivals, ContactIndex index, const FreshLanes& fresh, std::size_t lane) {
    if (arrivals.empty() || arrivals.back().count == batchLanes) arrivals.emplace_back();
    Arrivals& last = arrivals.back();
    last.contacts[last.count] = index;
    copyLane(last.fresh, last.count, fresh, lane, freshRows);
    ++last.count;
}

/// Contacts whose boxes have parted are over.
void removeParted(WorldState& world, NearPairs& near) {
    const bool wraps = world.def.wrap.any();
    const auto overlap = [&](std::size_t slot) {
        const PairLanes& pairs = near.lanes[slot / batchLanes];
        const ProxyId a = pairs.proxyA[slot % batchLanes], b = pairs.proxyB[slot % batchLanes];
        return wraps ? world.space.boxesOverlap(a, b, world.contacts.contacts[near.contactOf[slot]].shift)
                     : world.space.boxesOverlap(a, b);
    };
    for (std::size_t slot = 0; slot < near.contactOf.size();) {
        if (overlap(slot))
            ++slot;
        else
            removeContact(world, near.contactOf[slot]);
    }
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

/// Not what is let through.
bool mayArrive(WorldState& world, ContactIndex index, const FreshLanes& fresh, std::size_t lane) {
    ContactRecord& contact = world.contacts.contacts[index];
    contact.met = true;
    if (!contact.ruled) return true;
    if (isSolid(world, index, faceOf(world, contact, manifoldAt(fresh, lane)))) return true;
    contact.manifold.count = 0;
    return false;
}

/// Of a batch of near contacts, from the given lane on.
void collideBatch(WorldState& world, const NearPairs& near, std::size_t start, std::vector<Arrivals>& arrivals,
                  double dt) {
    const std::size_t first = start - start % batchLanes;
    const std::size_t count = std::min<std::size_t>(batchLanes, near.contactOf.size() - first);
    const PairLanes& pairs = near.lanes[first / batchLanes];
    FreshLanes fresh;
    const Contacts contacts = near.contactOf.data() + first;
    if (&near == &world.contacts.nearBoxes)
        collideBoxes(world, pairs, contacts, count, fresh, dt);
    else
        collideOthers(world, pairs, contacts, count, fresh, dt);
    for (std::size_t lane = start - first; lane < count; ++lane) {
        if (fresh.count[lane] == 0) continue;
        const ContactIndex index = near.contactOf[first + lane];
        if (!mayArrive(world, index, fresh, lane)) continue;
        addArrival(arrivals, index, fresh, lane);
        wakeTouched(world, pairAt(near.lanes[first / batchLanes], lane), fresh, lane);
    }
}

/// Contacts that a wake-up adds while this goes on are looked at as well.
void collideNear(WorldState& world, std::vector<Arrivals>& arrivals, double dt) {
    ContactStore& store = world.contacts;
    for (const ContactIndex index : store.watched) store.contacts[index].met = false;
    for (const ContactIndex index : store.judged) store.contacts[index].met = false;
    std::size_t boxes = 0, others = 0;
    while (boxes < store.nearBoxes.contactOf.size() || others < store.nearOthers.contactOf.size()) {
        const bool isBoxes = boxes < store.nearBoxes.contactOf.size();
        const NearPairs& near = isBoxes ? store.nearBoxes : store.nearOthers;
        std::size_t& done = isBoxes ? boxes : others;
        const std::size_t start = done;
        done = std::min(start - start % batchLanes + batchLanes, near.contactOf.size());
        collideBatch(world, near, start, arrivals, dt);
    }
    for (const ContactIndex index : store.watched)
        if (!store.contacts[index].met) store.contacts[index].manifold.count = 0;
}

/// Into slots, if anything can come of it; else back into their records.
void settle(WorldState& world, Arrivals& arrivals, double dt) {
    ContactBatch batch{};
    ManifoldLanes manifolds{};
    for (std::size_t lane = 0; lane < arrivals.count; ++lane)
        fillLane(world, world.contacts.contacts[arrivals.contacts[lane]], batch, manifolds, lane);
    seeAround(world, arrivals.contacts, arrivals.count, arrivals.fresh);
    prepareLanes(world, batch, manifolds, arrivals.fresh, dt);
    guessImpulses(world, batch);
    for (std::size_t lane = 0; lane < arrivals.count; ++lane) {
        const ContactIndex index = arrivals.contacts[lane];
        world.graph.add(world.bodies, world.contacts, index, batch, manifolds, lane);
        if (bodiesReady(world, world.contacts.contacts[index])) continue;
        world.graph.remove(world.bodies, world.contacts, index);
        world.contacts.addNear(index);
    }
}

void part(WorldState& world, ContactIndex index) {
    ContactRecord& contact = world.contacts.contacts[index];
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.addNear(index);
    contact.manifold.count = 0;
    contact.memory = {};
    contact.rollImpulse = 0;
}

}  // namespace

bool bodiesReady(const WorldState& world, const ContactRecord& contact) {
    const auto ready = [&world](BodyIndex body) {
        return world.bodies.record[body].awake || !world.bodies.isDynamic(body);
    };
    return ready(contact.bodyA) && ready(contact.bodyB);
}

void findContacts(WorldState& world, double dt) {
    std::vector<ContactIndex> parted;
    for (std::size_t index = 0; index < world.graph.colours.size(); ++index) collideColour(world, index, parted, dt);
    judgeSolved(world, parted);
    removeParted(world, world.contacts.nearBoxes);
    removeParted(world, world.contacts.nearOthers);
    std::vector<Arrivals> arrivals;
    collideNear(world, arrivals, dt);
    forgetParted(world);
    for (const ContactIndex index : parted) part(world, index);
    for (Arrivals& some : arrivals) settle(world, some, dt);
}

}  // namespace plumb
