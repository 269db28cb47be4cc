// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/impact_pair.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/manifold.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>

namespace plumb {

namespace {

/// Where a pair should meet, a larger gap or a deeper overlap than this shows that the search has failed [m]. A search
/// that ended well is exact to rounding (see timeOfImpact), so a micrometre is far more than it leaves. An overlap may
/// be larger, because a pair may start its step in one.
constexpr double widestTouch = 1e-6;
constexpr double deepestTouch = 1e-3;

/// The two shapes of a contact, B as the periodic image that meets A.
struct MovingPair {
    MovingShape a, b;
};

MovingPair shapesOf(const ImpactStores& stores, const FlyingBodies& bodies, const ImpactPair& pair) {
    const ContactRecord& contact = stores.contacts[pair.contact];
    MovingPair shapes{bodies[pair.a].flight, bodies[pair.b].flight};
    shapes.a.shape = &stores.space[contact.proxyA].def.shape;
    shapes.b.shape = &stores.space[contact.proxyB].def.shape;
    shapes.b.from.center += contact.shift;
    return shapes;
}

/// Without friction, no impact can turn a disc about its centre. With an endless inertia, rounding of the arm does not
/// turn it either: a gas of smooth discs keeps its spin of exactly zero.
LooseBody looseBody(const BodyRecord& record, const MovingShape& shape, const BodyMotion& motion, double friction) {
    const bool cannotTurn = friction == 0 && discOf(shape) != nullptr;
    return {velocityOf(motion), record.inverseMass, cannotTurn ? 0.0 : record.inverseInertia};
}

/// A disc has one point. Two faces that meet flat push at both ends of their common part: one point would turn a box
/// that lands flat. Faces count as parallel if their manifold has two points within the tolerance; else the nearest
/// points of both shapes are the only ones that touch. size: bounding radius of the larger body [m].
std::size_t touchingPoints(const Convex& a, const Convex& b, const Encounter& e, double size,
                           MeetingPoint (&points)[2]) {
    const auto pointAt = [&e](const Vec2& at) { return MeetingPoint{at - e.a.center, at - e.b.center}; };
    points[0] = pointAt(0.5 * (e.distance.pointA + e.distance.pointB));
    if (a.count == 1 || b.count == 1) return 1;
    const double faceTolerance = 1e-5 * size;  // the manifold is computed in floats
    const Manifold m = manifold(a, b, relativePose(e.a, e.b), static_cast<float>(faceTolerance));
    if (m.count < 2) return 1;
    for (std::size_t p = 0; p < 2; ++p)
        points[p] = pointAt(e.a.center + e.a.rotation * Vec2(m.points[p].position.cast<double>()));
    return 2;
}

}  // namespace

/// Searched from the later of the two bodies' last impacts on: before it, one of them was on another path.
std::optional<double> nextImpact(const ImpactStores& stores, const FlyingBodies& bodies, const ImpactPair& pair,
                                 double dt) {
    if (pair.through || (!bodies.canFly(pair.a) && !bodies.canFly(pair.b))) return std::nullopt;
    const MovingPair shapes = shapesOf(stores, bodies, pair);
    return timeOfImpact(shapes.a, shapes.b, std::max(shapes.a.time, shapes.b.time), dt);
}

/// Only contacts with a rule or a one-way side cost anything here. What may pass is not asked again in this step (see
/// ImpactPair::through).
bool isLetThrough(const ImpactStores& stores, const FlyingBodies& bodies, const ImpactPair& pair, double time) {
    const ContactRecord& contact = stores.contacts[pair.contact];
    if (!contact.ruled || contact.verdict == Verdict::Solid) return false;
    const MovingPair shapes = shapesOf(stores, bodies, pair);
    const Encounter e = encounterAt(shapes.a, shapes.b, time);
    const Vec2 velocity = velocityAt(e.b, e.distance.pointB) - velocityAt(e.a, e.distance.pointA);
    const Face face{e.distance.normal, velocity, e.distance.separation};
    return !isSolid(stores.contacts, stores.bodies, stores.space, pair.contact, face);
}

/// In order: both bodies to the place where they meet, their true speeds there with fields, the one or two points that
/// touch, the impulses, their energy, and both flights begin anew. B is seen as the periodic image near A, and put back
/// at the end.
bool solvePair(ImpactStores& stores, FlyingBodies& bodies, const ImpactPair& pair, double time,
               ImpactOutcome& outcome) {
    const ContactRecord& contact = stores.contacts[pair.contact];
    const MovingPair shapes = shapesOf(stores, bodies, pair);
    Encounter e = encounterAt(shapes.a, shapes.b, time);
    if (e.distance.separation > widestTouch || e.distance.separation < -deepestTouch) return false;
    bodies.addFieldsAt(pair.a, e.a, time);
    bodies.addFieldsAt(pair.b, e.b, time);
    MeetingPoint points[2];
    const std::size_t count = touchingPoints(stores.space[contact.proxyA].convex, stores.space[contact.proxyB].convex,
                                             e, std::max(shapes.a.boundingRadius, shapes.b.boundingRadius), points);
    const auto& records = stores.bodies.record;
    LooseBodies both(looseBody(records[contact.bodyA], shapes.a, e.a, contact.friction),
                     looseBody(records[contact.bodyB], shapes.b, e.b, contact.friction));
    outcome.where = e.distance;
    outcome.add(solveMeeting({points, count}, e.distance.normal, impactLawOf(contact), 0, both));
    e.b.center -= contact.shift;  // back from the image to B's own place
    BodyMotion a = e.a, b = e.b;
    setVelocity(a, both.a.velocity);
    setVelocity(b, both.b.velocity);
    bodies.depart(pair.a, e.a, a, time);
    bodies.depart(pair.b, e.b, b, time);
    return true;
}

/// Leaves the contact as the solver would: its impulses can be read as forces over dt, and it is watched until its
/// surfaces are apart. The impacts of a step begin one touch; if an older one was going on, it ends first, so that
/// begins and ends alternate.
void storeOutcome(ImpactStores& stores, ContactIndex index, const ImpactOutcome& outcome, double dt, double hitSpeed,
                  TouchEvents& touches) {
    ContactRecord& contact = stores.contacts[index];
    if (stores.observer != nullptr) {
        const bool pushA = stores.bodies.isDynamic(contact.bodyA), pushB = stores.bodies.isDynamic(contact.bodyB);
        Vec2 ground(0, 0);
        if (pushA != pushB) ground = pushB ? outcome.onB : Vec2(-outcome.onB);
        stores.observer->noteImpact(outcome.friction, outcome.drivers, 0, ground);
    }
    contact.memory[0].totalNormal = static_cast<float>(outcome.normalImpulse);
    contact.memory[0].totalTangent = static_cast<float>(outcome.tangentImpulse);
    contact.memoryStep = dt;
    if (contact.touching) touches.ends.push_back({contact.proxyA, contact.proxyB});
    const ShapeTouch touch{contact.proxyA,       contact.proxyB,       contact.shift,
                           outcome.where.pointA, outcome.where.normal, outcome.approachSpeed};
    touches.begins.push_back(touch);
    if (outcome.approachSpeed > hitSpeed) touches.hits.push_back(touch);
    contact.touching = true;
    stores.contacts.watch(index);
}

}  // namespace plumb
