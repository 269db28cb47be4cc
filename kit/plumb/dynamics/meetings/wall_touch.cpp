// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/wall_touch.h>

#include <algorithm>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/pairs.h>

namespace plumb {

namespace {

ContactIndex contactOf(const WallTouchStores& stores, const ShiftedShapes& pair) {
    const ContactIndex found = findContact(stores.contacts, stores.bodies, stores.space, pair);
    if (found != none) return found;
    return addEarlyContact(stores.contacts, stores.bodies, stores.space, pair);
}

/// A contact in the solver reports its events itself, from its impulses and its approach speed.
void addToSolved(ContactGraph& graph, const ContactRecord& contact, const WallImpact& impact) {
    Colour& colour = graph.colours[contact.colour];
    const std::size_t b = contact.slot / batchLanes, lane = contact.slot % batchLanes;
    PointLanes& point = colour.batches[b].points[0];
    point.totalNormal[lane] += static_cast<float>(impact.normalImpulse);
    point.totalTangent[lane] += static_cast<float>(impact.tangentImpulse);
    float& approach = colour.manifolds[b].approachSpeed[lane];
    approach = std::max(approach, static_cast<float>(impact.approachSpeed));
}

void addToOther(ContactStore& contacts, ContactIndex index, const WallImpact& impact, double dt) {
    ContactRecord& contact = contacts[index];
    if (contact.state != ContactState::Impact) {
        contact.state = ContactState::Impact;
        contact.memory = {};
        contact.rollImpulse = 0;
        contacts.impacts.push_back(index);
    }
    contact.manifold = impact.hit.manifold;
    contact.memory[0].totalNormal += static_cast<float>(impact.normalImpulse);
    contact.memory[0].totalTangent += static_cast<float>(impact.tangentImpulse);
    contact.memoryStep = dt;
    contacts.watch(index);
}

}  // namespace

void reportWallImpact(const WallTouchStores& stores, const WallImpact& impact, double dt, double hitSpeed,
                      TouchEvents& touches) {
    if (stores.observer != nullptr)
        stores.observer->noteImpact(impact.friction, impact.drivers, impact.bounce, impact.impulse);
    const ShiftedShapes pair = inOrder(impact.hit.own, impact.hit.wall, impact.hit.shift);
    const ContactIndex index = contactOf(stores, pair);
    ContactRecord& contact = stores.contacts[index];
    if (contact.isSolved()) return addToSolved(stores.graph, contact, impact);
    if (!contact.isNear()) return;
    addToOther(stores.contacts, index, impact, dt);
    const Vec2 normal = pair.shapes.a == impact.hit.wall ? impact.normal : Vec2(-impact.normal);
    const ShapeTouch touch{pair.shapes.a, pair.shapes.b, pair.shift, impact.point, normal, impact.approachSpeed};
    if (!contact.touching) touches.begins.push_back(touch);
    if (impact.approachSpeed > hitSpeed) touches.hits.push_back(touch);
    contact.touching = true;
}

}  // namespace plumb
