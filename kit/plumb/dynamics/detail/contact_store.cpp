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
    unlink(bodies, *this, contact, 0, contacts[contact].bodyA);
    unlink(bodies, *this, contact, 1, contacts[contact].bodyB);
    contacts[contact].alive = false;
    free.push_back(contact);
}

void ContactStore::addNear(ContactIndex contact) {
    ContactRecord& c = contacts[contact];
    if (c.nearIndex != none || c.colour >= 0) return;
    c.nearIndex = static_cast<std::uint32_t>(near.size());
    near.push_back(contact);
}

void ContactStore::removeNear(ContactIndex contact) {
    ContactRecord& c = contacts[contact];
    if (c.nearIndex == none) return;
    const ContactIndex last = near.back();
    near[c.nearIndex] = last;
    contacts[last].nearIndex = c.nearIndex;
    near.pop_back();
    c.nearIndex = none;
}

}  // namespace plumb
