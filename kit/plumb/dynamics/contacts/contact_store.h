// SPDX-License-Identifier: MIT
// Which shapes are near each other, and what is known of each pair?
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/box_outline.h>
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

using ContactIndex = std::uint32_t;

/// Copies a lane of a struct that is so many rows of sixteen 4-byte values, whatever their names.
template <class Rows>
void copyLane(Rows& to, std::size_t toLane, const Rows& from, std::size_t fromLane, std::size_t rows) {
    unsigned char* target = reinterpret_cast<unsigned char*>(&to) + 4 * toLane;
    const unsigned char* source = reinterpret_cast<const unsigned char*>(&from) + 4 * fromLane;
    for (std::size_t row = 0; row < rows; ++row)
        std::memcpy(target + 4 * batchLanes * row, source + 4 * batchLanes * row, 4);
}

/// Impulses of one point [N s].
struct PointMemory {
    float normalImpulse = 0, tangentImpulse = 0;  ///< of half a sub-step, for warm starting
    float totalNormal = 0, totalTangent = 0;      ///< over the whole of the last step it was solved in
};

/// What the shapes' rules have said.
enum class Verdict : std::uint8_t {
    Open,     ///< not asked
    Solid,    ///< they may touch
    Through,  ///< not from this side
    Refused,  ///< a rule has said no
};
/// Is nothing to come of their being near?
inline bool letsPass(Verdict verdict) {
    return verdict == Verdict::Through || verdict == Verdict::Refused;
}

/// Where is a contact kept, and who takes care of it?
enum class ContactState : std::uint8_t {
    Free,    ///< its record is not in use
    Asleep,  ///< in its record only
    Near,    ///< in ContactStore.nearBoxes or nearOthers: collided once a step
    Impact,  ///< the same, and left to the impacts in this step
    Solved,  ///< in a slot of the solver: its shapes touch, or may touch within the step
};

/// Two shapes whose bounds overlap.
struct ContactRecord {
    ProxyId proxyA = 0, proxyB = 0;
    BodyIndex bodyA = 0, bodyB = 0;
    double friction = 0, restitution = 0;  ///< of the pair
    float rollingReach = 0;                ///< resisting torque over normal force [m]
    float surfaceSpeed = 0;                ///< of both surfaces, along the tangent [m/s]
    ContactState state = ContactState::Free;
    bool boxes = false;  ///< both shapes are boxes that lie straight in their bodies' frames
    bool touching = false;
    bool ruled = false;  ///< a shape of the two has a rule or is solid one way only
    bool met = false;    ///< of what is near: had a manifold in this step
    bool watched = false;
    Verdict verdict = Verdict::Open;
    std::uint32_t colour = 0;           ///< of what is solved: entry of ContactGraph.colours
    std::uint32_t slot = 0;             ///< of what is solved or near: where in its lanes
    Manifold manifold;                  ///< while it is not with the solver
    std::array<PointMemory, 2> memory;  ///< likewise
    float rollImpulse = 0;              ///< likewise
    float approachSpeed = 0;            ///< at the last step's start [m/s]
    double memoryStep = 0;              ///< the step that memory's totals are of [s]
    std::array<ContactIndex, 2> previous{none, none}, next{none, none};  ///< in the lists of A and B
    Vec2 shift{0, 0};  ///< so many rounds of the world bring B to A [m]

    bool isSolved() const { return state == ContactState::Solved; }
    bool isNear() const { return state == ContactState::Near || state == ContactState::Impact; }
};

/// Near contacts, in lanes; slot = batch * batchLanes + lane.
struct NearPairs {
    std::vector<PairLanes> lanes;
    std::vector<ContactIndex> contactOf;
};

struct ContactStore {
    std::vector<ContactRecord> records;
    std::vector<ContactIndex> free;
    std::vector<BoxOutline> boxes;  ///< of each proxy

    // With a body awake, and not with the solver:
    NearPairs nearBoxes;
    NearPairs nearOthers;               ///< of other shapes, in their boxes
    std::vector<ContactIndex> watched;  ///< those that were touching or had a manifold, until they have not; and more

    std::vector<ContactIndex> withVerdict;  ///< those with a verdict
    std::vector<ContactIndex> impacts;      ///< those left to the impacts in the last step that had such

    ContactRecord& operator[](ContactIndex contact) { return records[contact]; }
    const ContactRecord& operator[](ContactIndex contact) const { return records[contact]; }
    ContactIndex add(BodyStore& bodies, const ContactRecord& contact);
    void remove(BodyStore& bodies, ContactIndex contact);
    void addNear(ContactIndex contact);     ///< unless it is near or solved already
    void removeNear(ContactIndex contact);  ///< if it is
    NearPairs& nearOf(const ContactRecord& contact) { return contact.boxes ? nearBoxes : nearOthers; }
    int side(ContactIndex contact, BodyIndex body) const { return records[contact].bodyA == body ? 0 : 1; }
};

/// Puts the boxes of a contact into a lane.
void fillPair(const ContactStore& store, const ContactRecord& contact, PairLanes& pairs, std::size_t lane);

/// Can anything come of it in this step? Not with a sleeper: what might touch one has woken it.
inline bool areBodiesReady(const BodyStore& bodies, const ContactRecord& contact) {
    const auto ready = [&bodies](BodyIndex body) { return bodies.record[body].awake || !bodies.isDynamic(body); };
    return ready(contact.bodyA) && ready(contact.bodyB);
}

/// The other body of a contact.
inline BodyIndex otherOf(const ContactRecord& contact, BodyIndex body) {
    return contact.bodyA == body ? contact.bodyB : contact.bodyA;
}

/// Calls visit(contact) for each contact of a body; visit may remove the one it gets.
template <class Visit>
void forEachContact(const BodyStore& bodies, const ContactStore& store, BodyIndex body, Visit&& visit) {
    for (ContactIndex contact = bodies.links[body].firstContact; contact != none;) {
        const ContactIndex next = store[contact].next[static_cast<std::size_t>(store.side(contact, body))];
        visit(contact);
        contact = next;
    }
}

}  // namespace plumb
