// SPDX-License-Identifier: MIT
// Which shapes are near each other, and what is known of each pair?
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <plumb/collide/manifold.h>
#include <plumb/dynamics/detail/body_store.h>

namespace plumb {

using ContactIndex = std::uint32_t;

/// Impulses of one point [N s].
struct PointMemory {
    float normalImpulse = 0, tangentImpulse = 0;  ///< of half a sub-step, for warm starting
    float totalNormal = 0, totalTangent = 0;      ///< over the whole of the last step it was solved in
};

/// Two shapes whose boxes overlap.
struct ContactRecord {
    ProxyId proxyA = 0, proxyB = 0;
    BodyIndex bodyA = 0, bodyB = 0;
    double friction = 0, restitution = 0;
    bool alive = false;
    bool touching = false;
    bool isolated = false;  ///< left to the impacts in this step, not to the solver
    int colour = -1;        ///< where the solver has it: colour and slot; -1: nowhere
    std::uint32_t slot = 0;
    std::uint32_t activeIndex = none;
    Manifold manifold;
    std::array<PointMemory, 2> memory;                                   ///< while it is not with the solver
    double approachSpeed = 0;                                            ///< at the last step's start [m/s]
    double memoryStep = 0;                                               ///< the step that memory's totals are of [s]
    std::array<ContactIndex, 2> previous{none, none}, next{none, none};  ///< in the lists of A and B
};

struct ContactStore {
    std::vector<ContactRecord> contacts;
    std::vector<ContactIndex> free;
    std::vector<ContactIndex> active;  ///< with at least one body awake

    ContactIndex add(BodyStore& bodies, const ContactRecord& contact);
    void remove(BodyStore& bodies, ContactIndex contact);
    void activate(ContactIndex contact);
    void deactivate(ContactIndex contact);
    int side(ContactIndex contact, BodyIndex body) const { return contacts[contact].bodyA == body ? 0 : 1; }
};

/// Calls visit(contact) for each contact of a body; visit may remove the one it gets.
template <class Visit>
void forEachContact(const BodyStore& bodies, const ContactStore& store, BodyIndex body, Visit&& visit) {
    for (ContactIndex contact = bodies.record[body].firstContact; contact != none;) {
        const ContactIndex next = store.contacts[contact].next[static_cast<std::size_t>(store.side(contact, body))];
        visit(contact);
        contact = next;
    }
}

}  // namespace plumb
