// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/contact_store.h>

namespace plumb {

namespace {

std::size_t at(int side) {
    return static_cast<std::size_t>(side);
}

void link(BodyStore& bodies, ContactStore& store, ContactIndex contact, int side, BodyIndex body) {
    ContactRecord& c = store.contacts[contact];
    const ContactIndex head = bodies.record[body].firstContact;
    c.previous[at(side)] = none;
    c.next[at(side)] = head;
    if (head != none) store.contacts[head].previous[at(store.side(head, body))] = contact;
    bodies.record[body].firstContact = contact;
}

void unlink(BodyStore& bodies, ContactStore& store, ContactIndex contact, int side, BodyIndex body) {
    const ContactIndex previous = store.contacts[contact].previous[at(side)];
    const ContactIndex next = store.contacts[contact].next[at(side)];
    if (previous != none)
        store.contacts[previous].next[at(store.side(previous, body))] = next;
    else
        bodies.record[body].firstContact = next;
    if (next != none) store.contacts[next].previous[at(store.side(next, body))] = previous;
}

std::int32_t discsOf(BoxOutline::Kind a, BoxOutline::Kind b) {
    using Kind = BoxOutline::Kind;
    if (b == Kind::Disc && a != Kind::Other) return discSecond;
    return a == Kind::Disc && b != Kind::Other ? discFirst : noDisc;
}

}  // namespace

ContactIndex ContactStore::add(BodyStore& bodies, const ContactRecord& contact) {
    ContactIndex index = static_cast<ContactIndex>(contacts.size());
    if (free.empty()) {
        contacts.push_back(contact);
    } else {
        index = free.back();
        free.pop_back();
        contacts[index] = contact;
    }
    contacts[index].alive = true;
    link(bodies, *this, index, 0, contact.bodyA);
    link(bodies, *this, index, 1, contact.bodyB);
    return index;
}

void ContactStore::remove(BodyStore& bodies, ContactIndex contact) {
    removeNear(contact);
    if (contacts[contact].verdict != Verdict::Open) std::erase(judged, contact);
    unlink(bodies, *this, contact, 0, contacts[contact].bodyA);
    unlink(bodies, *this, contact, 1, contacts[contact].bodyB);
    contacts[contact].alive = false;
    free.push_back(contact);
}

void ContactStore::addNear(ContactIndex contact) {
    ContactRecord& c = contacts[contact];
    if (c.nearIndex != none || c.colour >= 0) return;
    if (!c.watched && (c.touching || c.manifold.count > 0)) {
        c.watched = true;
        watched.push_back(contact);
    }
    c.met = false;
    NearPairs& near = nearOf(c);
    const std::size_t slot = near.contactOf.size();
    c.nearIndex = static_cast<std::uint32_t>(slot);
    near.contactOf.push_back(contact);
    if (slot % batchLanes == 0) near.lanes.push_back(PairLanes{});
    fillPair(*this, c, near.lanes.back(), slot % batchLanes);
}

void ContactStore::removeNear(ContactIndex contact) {
    ContactRecord& c = contacts[contact];
    if (c.nearIndex == none) return;
    NearPairs& near = nearOf(c);
    const std::size_t slot = c.nearIndex, last = near.contactOf.size() - 1;
    near.contactOf[slot] = near.contactOf[last];
    contacts[near.contactOf[slot]].nearIndex = static_cast<std::uint32_t>(slot);
    near.contactOf.pop_back();
    c.nearIndex = none;
    copyLane(near.lanes[slot / batchLanes], slot % batchLanes, near.lanes.back(), last % batchLanes, pairRows);
    copyLane(near.lanes.back(), last % batchLanes, PairLanes{}, 0, pairRows);
    if (last % batchLanes == 0) near.lanes.pop_back();
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
    pairs.discs[lane] = discsOf(a.kind, b.kind);
    pairs.centerXA[lane] = a.centerX;
    pairs.centerYA[lane] = a.centerY;
    pairs.centerXB[lane] = b.centerX;
    pairs.centerYB[lane] = b.centerY;
    pairs.proxyA[lane] = contact.proxyA;
    pairs.proxyB[lane] = contact.proxyB;
}

}  // namespace plumb
