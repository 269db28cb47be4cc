// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/wall_impact.h>

#include <algorithm>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/pairs.h>

namespace plumb {

BodyMotion wallMotionAt(const WallHit& hit, double duration) {
    return motionAt(hit.wallSweep, hit.time, duration);
}

/// The law is that of the pair of shapes, whether they have a contact or not. The manifold belongs to the shape with
/// the lower number, which may be the wall.
WallImpact solveWallImpact(const WallView& view, const WallHit& hit, const BodyMotion& wall, const BodyMotion& body,
                           MeetingBodies& bodies) {
    const bool bodyFirst = hit.own < hit.wall;
    const BodyMotion& a = bodyFirst ? body : wall;
    WallImpact impact;
    impact.hit = hit;
    const Vec2 fromA = a.rotation * Vec2(hit.manifold.normal.cast<double>());
    impact.normal = (bodyFirst ? Vec2(-fromA) : fromA).normalized();
    MeetingPoint points[2];
    const auto count = static_cast<std::size_t>(hit.manifold.count);
    for (std::size_t p = 0; p < count; ++p) {
        const Vec2 at = a.center + a.rotation * Vec2(hit.manifold.points[p].position.cast<double>());
        if (p == 0) impact.point = at;
        points[p] = {at - wall.center, at - body.center};
    }
    if (count == 0) return impact;
    ContactRecord contact;
    contact.proxyA = std::min(hit.own, hit.wall);
    contact.proxyB = std::max(hit.own, hit.wall);
    mixMaterials(view.space, contact);
    const double resting =
        restingSpeed(view.bodies, view.space[hit.own].owner, view.space[hit.wall].owner, impact.normal);
    static_cast<Meeting&>(impact) = solveMeeting({points, count}, impact.normal, impactLawOf(contact), resting, bodies);
    return impact;
}

namespace {

/// A body that was deflected may meet a wall for which it has no contact: then one is made.
ContactIndex contactOf(MeetingStores& stores, const ShiftedShapes& pair) {
    const ContactIndex found = findContact(stores.contacts, stores.bodies, stores.space, pair);
    if (found != none) return found;
    return addEarlyContact(stores.contacts, stores.bodies, stores.space, pair);
}

/// A contact in the solver reports its events itself, from its impulses and its approach speed; so the impact only adds
/// to these.
void addToSolved(ContactGraph& graph, const ContactRecord& contact, const WallImpact& impact) {
    const ContactLane at = graph.laneOf(contact);
    PointLanes& point = at.batch.points[0];
    point.totalNormal[at.lane] += static_cast<float>(impact.normalImpulse);
    point.totalTangent[at.lane] += static_cast<float>(impact.tangentImpulse);
    float& approach = at.manifolds.approachSpeed[at.lane];
    approach = std::max(approach, static_cast<float>(impact.approachSpeed));
}

/// Makes a near contact one of an isolated impact, with this step's impulses only. Several impacts in a step add up.
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

void reportWallImpact(MeetingStores& stores, const WallImpact& impact, double dt, double hitSpeed,
                      TouchEvents& touches) {
    if (stores.observer != nullptr)
        stores.observer->noteImpact(impact.friction, impact.drivers, impact.bounce, impact.onB);
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
