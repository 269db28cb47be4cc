// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/isolated_impacts.h>

#include <plumb/dynamics/impacts/impact_candidates.h>
#include <plumb/dynamics/impacts/impact_events.h>

namespace plumb {

namespace {

/// Takes the contact from the solver for this step: impacts move its bodies, or nothing moved them towards each other.
void takeFromSolver(ContactGraph& graph, const ImpactStores& stores, ContactIndex index) {
    graph.remove(stores.bodies, stores.contacts, index);
    stores.contacts.addNear(index);
    ContactRecord& contact = stores.contacts[index];
    contact.state = ContactState::Impact;
    contact.memory = {};
    contact.rollImpulse = 0;
    stores.contacts.impacts.push_back(index);
}

/// Makes the contacts that were isolated impacts in the last step ordinary near contacts again.
void endImpacts(ContactStore& contacts) {
    for (const ContactIndex index : contacts.impacts)
        if (contacts[index].state == ContactState::Impact) contacts[index].state = ContactState::Near;
    contacts.impacts.clear();
}

/// Does the solver keep this contact? It does if it moves one of the bodies and the other is not moved by impacts.
bool isKept(const ImpactEvents& events, const ContactRecord& contact) {
    const bool moved = events.isMoved(contact.bodyA) || events.isMoved(contact.bodyB);
    return !moved && (events.isLeft(contact.bodyA) || events.isLeft(contact.bodyB));
}

/// Two that only graze each other do not touch.
bool gaveImpulse(const ImpactOutcome& outcome) {
    return static_cast<float>(outcome.normalImpulse) > 0;
}

}  // namespace

Impacts solveIsolatedImpacts(ContactGraph& graph, const ImpactStores& stores, double dt, double hitSpeed) {
    Impacts impacts;
    endImpacts(stores.contacts);
    const ImpactCandidates candidates = findImpactCandidates(graph, stores.contacts, stores.bodies, dt);
    if (candidates.contacts.empty()) return impacts;
    ImpactEvents events(stores, candidates, dt);
    events.run();
    events.storeBodies(impacts.trajectories);
    for (const ImpactPair& pair : events.pairs()) {
        const ContactRecord& contact = stores.contacts[pair.contact];
        const bool happened = pair.impacts > 0 && gaveImpulse(events.outcomeOf(pair)) &&
                              !events.isLeft(contact.bodyA) && !events.isLeft(contact.bodyB);
        if (happened || (contact.isSolved() && !isKept(events, contact))) takeFromSolver(graph, stores, pair.contact);
        if (happened) storeOutcome(stores, pair.contact, events.outcomeOf(pair), dt, hitSpeed, impacts.touches);
    }
    return impacts;
}

}  // namespace plumb
