// SPDX-License-Identifier: MIT
// Which shapes are near each other, and which data is stored for each pair?
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <vector>

#include <plumb/broad/pair.h>
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/collide/manifold.h>
#include <plumb/dynamics/bodies/body_store.h>
#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/space/detail/box_outline.h>

namespace plumb {

using ContactIndex = std::uint32_t;

/// Copies one lane of a struct that consists of this number of rows, each of sixteen 4-byte values.
template <class Rows>
void copyLane(Rows& to, std::size_t toLane, const Rows& from, std::size_t fromLane, std::size_t rows) {
    unsigned char* target = reinterpret_cast<unsigned char*>(&to) + 4 * toLane;
    const unsigned char* source = reinterpret_cast<const unsigned char*>(&from) + 4 * fromLane;
    for (std::size_t row = 0; row < rows; ++row)
        std::memcpy(target + 4 * batchLanes * row, source + 4 * batchLanes * row, 4);
}

/// Impulses of one point [N s].
struct PointMemory {
    float normalImpulse = 0, tangentImpulse = 0;  ///< in half a sub-step, for warm starting
    float totalNormal = 0, totalTangent = 0;      ///< in the whole last step in which it was solved
};

/// The result of the shapes' rules and one-way sides for a contact.
enum class Verdict : std::uint8_t {
    Open,     ///< not evaluated yet
    Solid,    ///< the shapes collide
    Through,  ///< a one-way side lets the other shape pass
    Refused,  ///< a rule has forbidden the contact
};
/// Do the shapes pass through each other?
inline bool letsPass(Verdict verdict) {
    return verdict == Verdict::Through || verdict == Verdict::Refused;
}

/// Where is a contact stored, and which phase processes it?
enum class ContactState : std::uint8_t {
    Free,    ///< its record is not in use
    Asleep,  ///< only in its record
    Near,    ///< in ContactStore.nearBoxes or nearOthers: collided once per step
    Impact,  ///< as Near, and processed as an isolated impact in this step
    Solved,  ///< in a slot of the solver: its shapes touch, or may touch during the step
};

/// Two shapes whose bounds overlap. What those who follow a body's contacts read is in the first cache line.
struct alignas(64) ContactRecord {
    ProxyId proxyA = 0, proxyB = 0;
    BodyIndex bodyA = 0, bodyB = 0;
    std::array<ContactIndex, 2> previous{none, none}, next{none, none};  ///< in the lists of A and B
    Vec2 shift{0, 0};          ///< whole periods of the world that bring B near A [m]
    std::uint32_t colour = 0;  ///< only if solved: index in ContactGraph.colours
    std::uint32_t slot = 0;    ///< only if solved or near: batch * batchLanes + lane
    ContactState state = ContactState::Free;
    bool boxes = false;     ///< both shapes are boxes parallel to the axes of their bodies' frames
    bool touching = false;  ///< a touch has begun and has not ended
    bool ruled = false;     ///< one of the shapes has a rule or a one-way side
    bool met = false;       ///< only if near: it had a manifold in this step
    bool watched = false;   ///< it is in ContactStore.watched
    bool overlaps = false;  ///< it is in ContactStore.overlaps
    Verdict verdict = Verdict::Open;

    double friction = 0, restitution = 0;  ///< of the pair
    float rollingArm = 0;                  ///< resisting torque over normal force [m]
    float surfaceSpeed = 0;                ///< sum of both surfaces' speeds along the tangent [m/s]
    float approachSpeed = 0;               ///< at the last step's start [m/s]
    float rollImpulse = 0;                 ///< valid while it is not in the solver
    double memoryStep = 0;                 ///< dt of the step to which memory belongs [s]
    Manifold manifold;                     ///< valid while it is not in the solver
    std::array<PointMemory, 2> memory;     ///< valid while it is not in the solver

    bool isSolved() const { return state == ContactState::Solved; }
    bool isNear() const { return state == ContactState::Near || state == ContactState::Impact; }
};
static_assert(sizeof(ContactRecord) == 192);

/// Two shapes whose bounds overlap, with b shifted by whole periods of the world.
struct ShiftedShapes {
    Pair shapes;
    Vec2 shift{0, 0};  ///< [m]
};

/// Near contacts, in lanes: slot = batch * batchLanes + lane.
struct NearPairs {
    std::vector<PairLanes> lanes;
    std::vector<ContactIndex> contactOf;
};

/// A contact of two shapes that were put into each other.
struct DeepContact {
    ContactIndex contact = 0;
    float depth[2] = {0, 0};  ///< of its points at the step's start, beyond what its spring sees [m]
};

struct ContactStore {
    std::vector<ContactRecord> records;
    std::vector<ContactIndex> free;
    std::vector<BoxOutline> boxes;        ///< of each proxy
    std::vector<CornerRows> corners;      ///< of each proxy
    std::vector<CornerRows> moreCorners;  ///< of each proxy, if one has more than four; else empty

    // Contacts that have an awake body and are not in the solver:
    NearPairs nearBoxes;
    NearPairs nearOthers;               ///< contacts in which a shape is not a box
    std::vector<ContactIndex> watched;  ///< all that touch or had a manifold, and perhaps others

    std::vector<ContactIndex> withVerdict;  ///< contacts whose verdict is not Open
    std::vector<DeepContact> overlaps;      ///< contacts that began deep in overlap
    std::vector<ContactIndex> impacts;      ///< those with state Impact in the last step
    std::vector<ContactIndex> predicted;    ///< in this step, for bodies that spin: where they meet is predicted
    std::vector<Pair> leftOut;              ///< pairs of crowds without a contact, also of shapes that are gone
    std::vector<Pair> early;                ///< shapes that got a contact before the next search, which may find them

    ContactRecord& operator[](ContactIndex contact) { return records[contact]; }
    const ContactRecord& operator[](ContactIndex contact) const { return records[contact]; }
    ContactIndex add(BodyStore& bodies, const ContactRecord& contact);
    void remove(BodyStore& bodies, ContactIndex contact);
    void addNear(ContactIndex contact);     ///< does nothing if it is near or solved already
    void removeNear(ContactIndex contact);  ///< does nothing if it is not near
    void watch(ContactIndex contact);       ///< adds it to watched if it is not there
    NearPairs& nearOf(const ContactRecord& contact) { return contact.boxes ? nearBoxes : nearOthers; }
    int side(ContactIndex contact, BodyIndex body) const { return records[contact].bodyA == body ? 0 : 1; }
};

/// The place of a contact in an order that depends only on the order in which its shapes were made, not on when the
/// contact was made, nor on what happens elsewhere in the world.
inline std::tuple<ProxyId, ProxyId, double, double> shapesOf(const ContactRecord& contact) {
    return {contact.proxyA, contact.proxyB, contact.shift.x(), contact.shift.y()};
}

/// Sets how a proxy's shape is collided.
void setOutline(ContactStore& store, ProxyId proxy, const BoxOutline& box, const Convex& convex);
/// Writes the boxes of a contact's shapes into a lane.
void fillPair(const ContactStore& store, const ContactRecord& contact, PairLanes& pairs, std::size_t lane);

/// Can the contact act in this step? Not if one of its bodies sleeps: a body that might touch a sleeper has woken it
/// before.
inline bool areBodiesReady(const BodyStore& bodies, const ContactRecord& contact) {
    const auto ready = [&bodies](BodyIndex body) { return bodies.record[body].awake || !bodies.isDynamic(body); };
    return ready(contact.bodyA) && ready(contact.bodyB);
}

/// The other body of a contact.
inline BodyIndex otherOf(const ContactRecord& contact, BodyIndex body) {
    return contact.bodyA == body ? contact.bodyB : contact.bodyA;
}

/// Calls visit(contact) for each contact of a body; visit may remove the contact that it gets.
template <class Visit>
void forEachContact(const BodyStore& bodies, const ContactStore& store, BodyIndex body, Visit&& visit) {
    for (ContactIndex contact = bodies.links[body].firstContact; contact != none;) {
        const ContactIndex next = store[contact].next[static_cast<std::size_t>(store.side(contact, body))];
        visit(contact);
        contact = next;
    }
}

/// Is test(contact) true for a contact of a body? Asks no more contacts after that.
template <class Test>
bool anyContact(const BodyStore& bodies, const ContactStore& store, BodyIndex body, Test&& test) {
    for (ContactIndex contact = bodies.links[body].firstContact; contact != none;
         contact = store[contact].next[static_cast<std::size_t>(store.side(contact, body))])
        if (test(contact)) return true;
    return false;
}

}  // namespace plumb
