// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/narrow_phase.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/foresee.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/lane_collider.h>
#include <plumb/dynamics/detail/lanes.h>

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

Approach approachOf(const WorldState& world, const ContactRecord& contact) {
    const BodyPlace& a = world.bodies.place[contact.bodyA];
    const BodyPlace& b = world.bodies.place[contact.bodyB];
    const float x = b.shiftX - a.shiftX, y = b.shiftY - a.shiftY;
    const float turn = a.turn + b.turn;
    return {std::sqrt(x * x + y * y) + turn + contactMargin, turn, {a.cos * x + a.sin * y, a.cos * y - a.sin * x}};
}

/// Of any two shapes. Those that cannot come together along their normal in this step will not touch in it.
Manifold manifoldOf(const WorldState& world, const ContactRecord& contact, double dt) {
    const Approach approach = approachOf(world, contact);
    const RelativePose pose = relativePose(world.bodies.motion[contact.bodyA], world.bodies.motion[contact.bodyB]);
    const Manifold m = manifold(world.proxyA(contact).convex, world.proxyB(contact).convex, pose, approach.margin);
    if (m.count == 0 || nearestOf(m) <= contactMargin) return m;
    const float closing = approach.turn - approach.shift.dot(m.normal);
    return nearestOf(m) > closing ? Manifold{} : foreseen(world, contact, approach.margin, dt);
}

bool isUncertain(const FreshLanes& fresh) {
    return std::any_of(std::begin(fresh.uncertain), std::end(fresh.uncertain), [](std::int32_t u) { return u != 0; });
}

/// Contacts in the lanes of one batch.
struct LaneContacts {
    const ContactIndex* contacts = nullptr;
    std::size_t count = 0;
    bool boxes = false;
};

/// Finds the manifolds of all lanes.
void collideLanes(const WorldState& world, const LaneContacts& lanes, const ContactBatch& batch,
                  const ManifoldLanes& manifolds, FreshLanes& fresh, double dt) {
    const auto contactAt = [&](std::size_t lane) -> const ContactRecord& {
        return world.contacts.contacts[lanes.contacts[lane]];
    };
    if (!lanes.boxes) {
        for (std::size_t lane = 0; lane < lanes.count; ++lane)
            setFresh(fresh, lane, manifoldOf(world, contactAt(lane), dt));
        for (std::size_t lane = lanes.count; lane < batchLanes; ++lane) setFresh(fresh, lane, {});
        return;
    }
    world.collider->collideBoxes(batch, manifolds, world.bodies.place.data(), fresh);
    if (!isUncertain(fresh)) return;
    for (std::size_t lane = 0; lane < lanes.count; ++lane) {
        if (fresh.uncertain[lane] == 0) continue;
        const ContactRecord& contact = contactAt(lane);
        setFresh(fresh, lane, foreseen(world, contact, approachOf(world, contact).margin, dt));
    }
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
        const LaneContacts lanes{&colour.contactOf[first], count, index % 2 == 0};
        collideLanes(world, lanes, colour.batches[b], colour.manifolds[b], fresh, dt);
        prepareLanes(world, colour.batches[b], colour.manifolds[b], fresh, dt);
        for (std::size_t lane = 0; lane < count; ++lane)
            if (fresh.count[lane] == 0) parted.push_back(colour.contactOf[first + lane]);
    }
}

void wakeTouched(WorldState& world, const ContactRecord& contact, const FreshLanes& fresh, std::size_t lane) {
    float nearest = fresh.points[0].separation[lane];
    if (fresh.count[lane] > 1) nearest = std::min(nearest, fresh.points[1].separation[lane]);
    if (nearest > approachOf(world, contact).margin - (contactMargin - trembling)) return;
    for (const BodyIndex body : {contact.bodyA, contact.bodyB})
        if (world.bodies.isDynamic(body) && !world.bodies.record[body].awake) wakeIsland(world, body);
}

/// Up to sixteen near contacts of one kind, on their way through the kernels.
struct NearBatch {
    ContactBatch batch{};
    ManifoldLanes manifolds{};
    ContactIndex contacts[batchLanes];
    std::size_t count = 0;
};

/// What has come to touch, with what has been found of it.
struct Arrivals {
    std::vector<NearBatch> batches;
    struct Lane {
        std::size_t batch, lane;
    };
    std::vector<Lane> lanes;
};

void collideNear(WorldState& world, NearBatch& near, bool boxes, Arrivals& arrivals, double dt) {
    if (near.count == 0) return;
    FreshLanes fresh;
    for (std::size_t lane = near.count; lane < batchLanes; ++lane) {
        near.batch.bodyA[lane] = near.batch.bodyB[lane] = noBody;
        near.manifolds.count[lane] = 0;
    }
    collideLanes(world, {near.contacts, near.count, boxes}, near.batch, near.manifolds, fresh, dt);
    bool arrived = false;
    for (std::size_t lane = 0; lane < near.count; ++lane) {
        if (fresh.count[lane] > 0) wakeTouched(world, world.contacts.contacts[near.contacts[lane]], fresh, lane);
        arrived = arrived || fresh.count[lane] > 0;
    }
    if (arrived) prepareLanes(world, near.batch, near.manifolds, fresh, dt);
    for (std::size_t lane = 0; lane < near.count; ++lane) {
        world.contacts.contacts[near.contacts[lane]].manifold.count = fresh.count[lane];
        if (fresh.count[lane] > 0) arrivals.lanes.push_back({arrivals.batches.size(), lane});
    }
    if (arrived) arrivals.batches.push_back(near);
    near.count = 0;
}

/// Contacts that a wake-up adds while this goes on are looked at as well.
void collideAllNear(WorldState& world, Arrivals& arrivals, double dt) {
    NearBatch boxes, others;
    std::vector<ContactIndex>& near = world.contacts.near;
    for (std::size_t i = 0; i < near.size();) {
        const ContactIndex index = near[i];
        ContactRecord& contact = world.contacts.contacts[index];
        contact.isolated = false;
        if (!world.space.boxesOverlap(contact.proxyA, contact.proxyB)) {
            removeContact(world, index);
        } else {
            NearBatch& batch = contact.boxes ? boxes : others;
            fillLane(world, contact, batch.batch, batch.manifolds, batch.count);
            batch.contacts[batch.count++] = index;
            if (batch.count == batchLanes) collideNear(world, batch, contact.boxes, arrivals, dt);
            ++i;
        }
        if (i == near.size()) {
            collideNear(world, boxes, true, arrivals, dt);
            collideNear(world, others, false, arrivals, dt);
        }
    }
}

/// Into a slot, if anything can come of it; else back into its record.
void settle(WorldState& world, const NearBatch& near, std::size_t lane) {
    const ContactIndex index = near.contacts[lane];
    const ContactRecord& contact = world.contacts.contacts[index];
    world.graph.add(world.bodies, world.contacts, index, near.batch, near.manifolds, lane);
    if (bodiesReady(world, contact)) return;
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.addNear(index);
}

void part(WorldState& world, ContactIndex index) {
    ContactRecord& contact = world.contacts.contacts[index];
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.addNear(index);
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
    Arrivals arrivals;
    collideAllNear(world, arrivals, dt);
    for (const ContactIndex index : parted) part(world, index);
    for (const Arrivals::Lane& at : arrivals.lanes) settle(world, arrivals.batches[at.batch], at.lane);
}

}  // namespace plumb
