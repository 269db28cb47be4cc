// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/contact_store.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace plumb {

namespace {

std::size_t at(int side) {
    return static_cast<std::size_t>(side);
}

/// A body's contacts are a doubly linked list through their records: a contact is in the lists of its two bodies. So
/// adding and removing are O(1), and a record needs no memory of its own. A new contact comes first.
void link(BodyStore& bodies, ContactStore& store, ContactIndex contact, int side, BodyIndex body) {
    ContactRecord& c = store[contact];
    const ContactIndex head = bodies.links[body].firstContact;
    c.previous[at(side)] = none;
    c.next[at(side)] = head;
    if (head != none) store[head].previous[at(store.side(head, body))] = contact;
    bodies.links[body].firstContact = contact;
}

void unlink(BodyStore& bodies, ContactStore& store, ContactIndex contact, int side, BodyIndex body) {
    const ContactIndex previous = store[contact].previous[at(side)];
    const ContactIndex next = store[contact].next[at(side)];
    if (previous != none)
        store[previous].next[at(store.side(previous, body))] = next;
    else
        bodies.links[body].firstContact = next;
    if (next != none) store[next].previous[at(store.side(next, body))] = previous;
}

/// Which code collides two shapes that are not both boxes: the cheapest that is right for them. It is chosen when the
/// pair gets a slot. A disc on a segment with neighbours is collided one by one: lanes of discs do not know the
/// neighbours.
std::int32_t kernelOf(const BoxOutline& a, const BoxOutline& b) {
    using Kind = BoxOutline::Kind;
    const auto isForDiscs = [](const BoxOutline& o) { return o.kind != Kind::Other || (o.corners > 0 && !o.chained); };
    if (b.kind == Kind::Disc && isForDiscs(a)) return discSecond;
    if (a.kind == Kind::Disc && isForDiscs(b)) return discFirst;
    if (a.corners == 0 || b.corners == 0) return noKernel;
    return a.chained || b.chained ? onChain : asPolygons;
}

/// Four corners of a polygon from this one on. Where it has fewer, its first corner is repeated: a copy changes neither
/// the bounds nor the smallest distance.
CornerRows rowsOf(const Convex& convex, std::size_t first) {
    CornerRows rows;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t corner = first + i < static_cast<std::size_t>(convex.count) ? first + i : 0;
        rows.x[i] = convex.vertices[corner].x();
        rows.y[i] = convex.vertices[corner].y();
        rows.normalX[i] = convex.normals[corner].x();
        rows.normalY[i] = convex.normals[corner].y();
    }
    return rows;
}

/// Gives each new entry copies of its proxy's first corner, so that a batch of unequal polygons can read eight corners
/// of each.
void growMoreCorners(ContactStore& store) {
    for (std::size_t proxy = store.moreCorners.size(); proxy < store.corners.size(); ++proxy) {
        const CornerRows& first = store.corners[proxy];
        CornerRows& more = store.moreCorners.emplace_back();
        std::fill(std::begin(more.x), std::end(more.x), first.x[0]);
        std::fill(std::begin(more.y), std::end(more.y), first.y[0]);
    }
}

}  // namespace

ContactIndex ContactStore::add(BodyStore& bodies, const ContactRecord& contact) {
    ContactIndex index = static_cast<ContactIndex>(records.size());
    if (free.empty()) {
        records.push_back(contact);
    } else {
        index = free.back();
        free.pop_back();
        records[index] = contact;
    }
    records[index].state = ContactState::Asleep;
    link(bodies, *this, index, 0, contact.bodyA);
    link(bodies, *this, index, 1, contact.bodyB);
    return index;
}

void ContactStore::remove(BodyStore& bodies, ContactIndex contact) {
    removeNear(contact);
    if (records[contact].verdict != Verdict::Open) std::erase(withVerdict, contact);
    if (records[contact].overlaps)
        std::erase_if(overlaps, [contact](const DeepContact& overlap) { return overlap.contact == contact; });
    // The entry in watched may stay: findTouchEvents drops what is not near. So removing is O(1), but for the two lists
    // above, which are short.
    unlink(bodies, *this, contact, 0, records[contact].bodyA);
    unlink(bodies, *this, contact, 1, records[contact].bodyB);
    records[contact].state = ContactState::Free;
    free.push_back(contact);
}

void ContactStore::addNear(ContactIndex contact) {
    ContactRecord& c = records[contact];
    if (c.state != ContactState::Asleep) return;
    if (c.touching || c.manifold.count > 0) watch(contact);
    c.met = false;
    NearPairs& near = nearOf(c);
    const std::size_t slot = near.contactOf.size();
    c.state = ContactState::Near;
    c.slot = static_cast<std::uint32_t>(slot);
    near.contactOf.push_back(contact);
    if (slot % batchLanes == 0) near.lanes.push_back(PairLanes{});
    fillPair(*this, c, near.lanes.back(), slot % batchLanes);
}

void ContactStore::watch(ContactIndex contact) {
    if (!std::exchange(records[contact].watched, true)) watched.push_back(contact);
}

void ContactStore::removeNear(ContactIndex contact) {
    ContactRecord& c = records[contact];
    if (!c.isNear()) return;
    NearPairs& near = nearOf(c);
    // The last contact moves into the gap, so that lanes stay dense. That changes the order of the near contacts;
    // NarrowPhase::sortArrivals undoes its effect.
    const std::size_t slot = c.slot, last = near.contactOf.size() - 1;
    near.contactOf[slot] = near.contactOf[last];
    records[near.contactOf[slot]].slot = static_cast<std::uint32_t>(slot);
    near.contactOf.pop_back();
    c.state = ContactState::Asleep;
    copyLane(near.lanes[slot / batchLanes], slot % batchLanes, near.lanes.back(), last % batchLanes, pairRows);
    // Lanes that are not in use are computed with the others: their bodies must be slot 0.
    copyLane(near.lanes.back(), last % batchLanes, PairLanes{}, 0, pairRows);
    if (last % batchLanes == 0) near.lanes.pop_back();
}

void setOutline(ContactStore& store, ProxyId proxy, const BoxOutline& box, const Convex& convex) {
    if (store.boxes.size() <= proxy) store.boxes.resize(proxy + std::size_t{1});
    const std::size_t count = store.boxes.size();
    BoxOutline& outline = store.boxes[proxy];
    outline = box;
    outline.chained = isChainSegment(convex);
    outline.corners = convex.count > 1 && convex.count <= mostCorners ? static_cast<std::uint8_t>(convex.count) : 0;
    store.corners.resize(count);
    store.corners[proxy] = outline.corners > 0 ? rowsOf(convex, 0) : CornerRows{};
    // A world without polygons of more than four corners saves a cache line a shape.
    if (outline.corners <= 4 && store.moreCorners.empty()) return;
    growMoreCorners(store);
    store.moreCorners[proxy] = outline.corners > 0 ? rowsOf(convex, 4) : CornerRows{};
}

void fillPair(const ContactStore& store, const ContactRecord& contact, PairLanes& pairs, std::size_t lane) {
    const BoxOutline& a = store.boxes[contact.proxyA];
    const BoxOutline& b = store.boxes[contact.proxyB];
    pairs.bodyA[lane] = contact.bodyA;
    pairs.bodyB[lane] = contact.bodyB;
    pairs.halfXA[lane] = a.halfX;
    pairs.halfYA[lane] = a.halfY;
    pairs.halfXB[lane] = b.halfX;
    pairs.halfYB[lane] = b.halfY;
    pairs.radiusA[lane] = a.radius;
    pairs.radiusB[lane] = b.radius;
    pairs.kernel[lane] = kernelOf(a, b);
    // The kernel of discs takes the other shape as a polygon only if it is not a box: a box's distance needs no
    // corners.
    const bool disc = pairs.kernel[lane] == discFirst || pairs.kernel[lane] == discSecond;
    pairs.cornersA[lane] = disc && a.kind != BoxOutline::Kind::Other ? 0 : a.corners;
    pairs.cornersB[lane] = disc && b.kind != BoxOutline::Kind::Other ? 0 : b.corners;
    pairs.centerXA[lane] = a.centerX;
    pairs.centerYA[lane] = a.centerY;
    pairs.centerXB[lane] = b.centerX;
    pairs.centerYB[lane] = b.centerY;
    pairs.proxyA[lane] = contact.proxyA;
    pairs.proxyB[lane] = contact.proxyB;
}

}  // namespace plumb
