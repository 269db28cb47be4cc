// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/overlaps.h>

#include <algorithm>

namespace plumb {

namespace {

/// The overlap that a contact's spring pushes out itself [m], and as a share of the smaller inradius [-]. It is more
/// than loads press bodies in at rest (millimetres), so that what only rests is never shifted.
constexpr double shallow = 0.01, shallowShare = 0.1;

/// Of the thinner one of the bodies that the spring can move: the thickness of a floor says nothing about how far a
/// crate may be shifted.
float shallowOf(const BodyStore& bodies, const ContactRecord& contact) {
    double inradius = shallow / shallowShare;
    for (const BodyIndex body : {contact.bodyA, contact.bodyB})
        if (bodies.isDynamic(body)) inradius = std::min(inradius, bodies.record[body].inradius);
    return static_cast<float>(shallowShare * inradius);
}

/// The solver sees no separation below -least. Both copies are changed, because separations during the step count from
/// startSeparation. Returns true if something is hidden.
bool hide(ContactGraph& graph, const ContactRecord& contact, float least, DeepContact& overlap) {
    const ContactLane at = graph.laneOf(contact);
    for (std::size_t i = 0; i < 2; ++i) {
        PointLanes& p = at.batch.points[i];
        const float visible = std::max(p.startSeparation[at.lane], -least);
        overlap.depth[i] = visible - p.startSeparation[at.lane];
        p.startSeparation[at.lane] = p.separation[at.lane] = visible;
    }
    return overlap.depth[0] > 0 || overlap.depth[1] > 0;
}

/// Only where a body was placed: overlap from loads and blows is a compressed spring, and must push back.
void noteIfDeep(ContactStore& contacts, const ContactGraph& graph, const BodyStore& bodies, ContactIndex index) {
    ContactRecord& contact = contacts[index];
    if (!contact.isSolved() || contact.overlaps) return;
    const float least = std::min(graph.separationOf(contact, 0), graph.separationOf(contact, 1));
    if (least >= -shallowOf(bodies, contact)) return;
    contact.overlaps = true;
    contacts.overlaps.push_back({index, {0, 0}});
}

}  // namespace

void measureOverlaps(ContactStore& contacts, ContactGraph& graph, const BodyStore& bodies) {
    for (const BodyIndex body : bodies.placed)
        forEachContact(bodies, contacts, body, [&](ContactIndex index) { noteIfDeep(contacts, graph, bodies, index); });
    std::erase_if(contacts.overlaps, [&](DeepContact& overlap) {
        ContactRecord& contact = contacts[overlap.contact];
        // It is measured again when it wakes.
        if (contact.state == ContactState::Asleep) return false;
        contact.overlaps = contact.isSolved() && hide(graph, contact, shallowOf(bodies, contact), overlap);
        return !contact.overlaps;
    });
}

}  // namespace plumb
