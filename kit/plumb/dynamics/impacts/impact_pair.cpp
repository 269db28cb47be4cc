// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/impact_pair.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/contact_rules.h>

namespace plumb {

namespace {

/// Where a pair should meet, a larger gap or a deeper overlap than this shows that the search has failed [m]. A search
/// that ended well is exact to rounding (see timeOfImpact), so a micrometre is far more than it leaves. An overlap may
/// be larger, because a pair may start its step in one.
constexpr double widestTouch = 1e-6;
constexpr double deepestTouch = 1e-3;

/// The states of the two bodies of a pair, A first.
using TwoMotions = std::array<BodyMotion, 2>;

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
ImpactBody impactBody(const BodyRecord& record, const MovingShape& shape, const BodyMotion& motion, double friction) {
    const bool cannotTurn = friction == 0 && discOf(shape) != nullptr;
    return {motion, record.inverseMass, cannotTurn ? 0.0 : record.inverseInertia};
}

/// Adds the impulses of an impact and their work. An impulse P along a direction in which the speed goes from v to v'
/// does the work P (v + v') / 2, exactly. The belt's surface and bodies that impulses do not move are drivers: their
/// work is entered apart, or friction on a moving belt would seem to create energy.
void addImpulses(const BodyStore& bodies, const ContactRecord& contact, const std::vector<PointImpulse>& given,
                 const TwoMotions& before, const TwoMotions& after, ImpactOutcome& outcome) {
    const Vec2 n = outcome.where.normal, t = perp(n);
    for (const PointImpulse& point : given) {
        const Vec2 va = 0.5 * (velocityAt(before[0], point.point) + velocityAt(after[0], point.point));
        const Vec2 vb = 0.5 * (velocityAt(before[1], point.point) + velocityAt(after[1], point.point));
        const Vec2 impulse = n * point.normal + t * point.tangent;
        const double belt = static_cast<double>(contact.surfaceSpeed);
        outcome.normalImpulse += point.normal;
        outcome.tangentImpulse += point.tangent;
        outcome.friction += point.tangent * (t.dot(vb - va) + belt);
        outcome.drivers -= point.tangent * belt;
        if (!bodies.isDynamic(contact.bodyA)) outcome.drivers += impulse.dot(va);
        if (!bodies.isDynamic(contact.bodyB)) outcome.drivers -= impulse.dot(vb);
        outcome.onA -= impulse;
    }
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
bool solvePair(const ImpactStores& stores, FlyingBodies& bodies, const ImpactPair& pair, double time,
               ImpactOutcome& outcome) {
    const ContactRecord& contact = stores.contacts[pair.contact];
    const MovingPair shapes = shapesOf(stores, bodies, pair);
    Encounter e = encounterAt(shapes.a, shapes.b, time);
    if (e.distance.separation > widestTouch || e.distance.separation < -deepestTouch) return false;
    bodies.addFieldsAt(pair.a, e.a, time);
    bodies.addFieldsAt(pair.b, e.b, time);
    outcome.where = e.distance;
    outcome.approachSpeed = std::max(outcome.approachSpeed, e.closingSpeed);
    // Two faces that meet flat push at both ends of their common part: one point would turn a box that lands flat.
    const std::vector<Vec2> points =
        touchingPoints(stores.space[contact.proxyA].convex, e.a, stores.space[contact.proxyB].convex, e.b, e.distance,
                       std::max(shapes.a.boundingRadius, shapes.b.boundingRadius));
    const auto& records = stores.bodies.record;
    ImpactBody a = impactBody(records[contact.bodyA], shapes.a, e.a, contact.friction);
    ImpactBody b = impactBody(records[contact.bodyB], shapes.b, e.b, contact.friction);
    const ImpactLaw law{contact.restitution, contact.friction, static_cast<double>(contact.surfaceSpeed)};
    const std::vector<PointImpulse> given = solveImpact(points, e.distance.normal, law, a, b);
    addImpulses(stores.bodies, contact, given, {e.a, e.b}, {a.motion, b.motion}, outcome);
    e.b.center -= contact.shift;  // back from the image to B's own place
    b.motion.center -= contact.shift;
    bodies.depart(pair.a, e.a, a.motion, time);
    bodies.depart(pair.b, e.b, b.motion, time);
    return true;
}

/// Leaves the contact as the solver would: its impulses can be read as forces over dt, and it is watched until its
/// surfaces are apart. The impacts of a step begin one touch; if an older one was going on, it ends first, so that
/// begins and ends alternate.
void storeOutcome(const ImpactStores& stores, ContactIndex index, const ImpactOutcome& outcome, double dt,
                  double hitSpeed, TouchEvents& touches) {
    ContactRecord& contact = stores.contacts[index];
    if (stores.observer != nullptr) {
        const bool pushA = stores.bodies.isDynamic(contact.bodyA), pushB = stores.bodies.isDynamic(contact.bodyB);
        Vec2 ground(0, 0);
        if (pushA != pushB) ground = pushA ? outcome.onA : Vec2(-outcome.onA);
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
