// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/impacts.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/contact_rules.h>
#include <plumb/dynamics/detail/field_flight.h>
#include <plumb/dynamics/detail/report_contacts.h>
#include <plumb/dynamics/detail/time_of_impact.h>
#include <plumb/impact/impact.h>

namespace plumb {

namespace {

/// More impacts than this for each body in one step: a heap, for the solver.
constexpr std::size_t impactsPerBody = 16;

/// A larger group is a heap as well: each impact is searched among all of them.
constexpr std::size_t largestGroup = 200;

/// What is farther apart than this has not met, and what is deeper than this has met before [m].
constexpr double lostTouch = 1e-6;
constexpr double lostWay = 1e-3;

struct Flyer {
    BodyIndex body = noBody;
    FlyingShape flight;                 ///< its shape is filled in for each contact
    std::optional<FieldFlight> fields;  ///< what it feels from there on
    FieldAccount account;               ///< what fields have done before
};

/// A contact between two flyers, and when they meet next.
struct Meeting {
    ContactIndex contact = 0;
    std::size_t a = 0, b = 0;
    std::optional<double> time;
    bool through = false;  ///< is let pass, as its rules say
    double approachSpeed = 0, normalImpulse = 0, tangentImpulse = 0;
    double friction = 0, drivers = 0;  ///< energy that friction and what is not pushed have given [J]
    Vec2 onA{0, 0};                    ///< impulse [N s]
    Distance where;
};

std::size_t flyerOf(std::vector<Flyer>& flyers, const WorldState& world, BodyIndex body) {
    const auto found = std::find_if(flyers.begin(), flyers.end(), [body](const Flyer& f) { return f.body == body; });
    if (found != flyers.end()) return static_cast<std::size_t>(found - flyers.begin());
    const BodyRecord& record = world.bodies.record[body];
    Flyer flyer;
    flyer.body = body;
    flyer.flight.localCenter = record.localCenter;
    flyer.flight.extent = record.extent;
    flyer.flight.from = world.bodies.motion[body];
    flyer.flight.law = flightLawOf(world, body);
    if (record.flight != none) flyer.fields = world.fields.flights[record.flight];
    flyers.push_back(flyer);
    return flyers.size() - 1;
}

/// Where fields have an end to its flight, at a time: the law is right about the place, and nearly about the velocity.
void endFlight(WorldState& world, Flyer& flyer, BodyMotion& at, double time) {
    if (!flyer.fields || flyer.fields->steady) return;
    const double flown = time - flyer.flight.time;
    const FieldFlight part = flightFrom(world, *flyer.fields, flyer.flight.from, flyer.flight.time, flown);
    const BodyMotion end = fly(flyer.flight.from, part.law, flown);
    at.velocity = end.velocity + part.rest.velocity;
    at.angularVelocity = end.angularVelocity + part.rest.spin;
    flyer.account += part.account;
}

/// From where it is now.
void flyOn(WorldState& world, Flyer& flyer, double dt) {
    if (!flyer.fields || flyer.fields->steady) return;
    const double left = dt - flyer.flight.time;
    flyer.fields = flightFrom(world, *flyer.fields, flyer.flight.from, flyer.flight.time, left);
    flyer.flight.law = flyer.fields->law;
}

FlyingShape shapeOf(const Flyer& flyer, const Proxy& proxy, const Vec2& shift) {
    FlyingShape shape = flyer.flight;
    shape.shape = &proxy.def.shape;
    shape.from.center += shift;
    return shape;
}

/// The two of a contact as they see each other.
struct FlyingPair {
    FlyingShape a, b;
};
FlyingPair shapesOf(const WorldState& world, const ContactRecord& contact, const Flyer& a, const Flyer& b) {
    return {shapeOf(a, world.proxyA(contact), {0, 0}), shapeOf(b, world.proxyB(contact), contact.shift)};
}

ImpactSide sideOf(const WorldState& world, const Flyer& flyer, const Vec2& point) {
    const BodyRecord& record = world.bodies.record[flyer.body];
    const BodyMotion& motion = flyer.flight.from;
    return {motion.velocity, motion.angularVelocity, record.inverseMass, record.inverseInertia, point - motion.center};
}

void apply(Flyer& flyer, const Vec2& velocity, double angularVelocity) {
    flyer.flight.from.velocity = velocity;
    flyer.flight.from.angularVelocity = angularVelocity;
}

/// Where the two touch: one point, or both ends of a common face.
std::vector<Vec2> touchingPoints(const WorldState& world, const ContactRecord& contact, const Flyer& a, const Flyer& b,
                                 const Distance& where) {
    const BodyMotion& ma = a.flight.from;
    const BodyMotion& mb = b.flight.from;
    const Convex& ca = world.proxyA(contact).convex;
    const Convex& cb = world.proxyB(contact).convex;
    const Vec2 middle = 0.5 * (where.pointA + where.pointB);
    if (ca.count == 1 || cb.count == 1) return {middle};
    const Rot toA = ma.rotation.inverse();
    const Vec2 shift = toA * Vec2(mb.center - ma.center);
    const Rot turn = toA * mb.rotation;
    const RelativePose pose{shift.cast<float>(), static_cast<float>(turn.cos), static_cast<float>(turn.sin)};
    const double faceTolerance = 1e-5 * std::max(a.flight.extent, b.flight.extent);  // float's, of a shape's size
    const Manifold m = manifold(ca, cb, pose, static_cast<float>(faceTolerance));
    if (m.count < 2) return {middle};
    std::vector<Vec2> points;
    for (const ManifoldPoint& p : m.points) points.push_back(ma.center + ma.rotation * Vec2(p.position.cast<double>()));
    return points;
}

/// What B was given at a point, along the normal and along perp(normal) [N s].
struct PointImpulse {
    Vec2 point{0, 0};
    double normal = 0, tangent = 0;
};

/// Two points at once: each parts at its share of its own approach; found by turns until nothing changes.
std::vector<PointImpulse> partFace(const WorldState& world, const Vec2& n, std::span<const Vec2> points, Flyer& a,
                                   Flyer& b, const ImpactLaw& law) {
    const auto speedAt = [&](const Vec2& p) {
        const BodyMotion& ma = a.flight.from;
        const BodyMotion& mb = b.flight.from;
        const Vec2 va = ma.velocity + perp(Vec2(p - ma.center)) * ma.angularVelocity;
        const Vec2 vb = mb.velocity + perp(Vec2(p - mb.center)) * mb.angularVelocity;
        return Vec2(vb - va);
    };
    struct Impulse {
        double wanted = 0, normal = 0, tangent = 0;
    };
    std::array<Impulse, 2> impulses;
    for (std::size_t i = 0; i < 2; ++i)
        impulses[i].wanted = -law.restitution * std::min(speedAt(points[i]).dot(n), 0.0);
    const auto push = [&](const Vec2& point, const Vec2& impulse) {
        const ImpactSide sa = sideOf(world, a, point);
        const ImpactSide sb = sideOf(world, b, point);
        apply(a, sa.velocity - impulse * sa.inverseMass,
              sa.angularVelocity - cross(sa.arm, impulse) * sa.inverseInertia);
        apply(b, sb.velocity + impulse * sb.inverseMass,
              sb.angularVelocity + cross(sb.arm, impulse) * sb.inverseInertia);
    };
    const auto inverseMass = [&](const Vec2& point, const Vec2& direction) {
        const ImpactSide sa = sideOf(world, a, point);
        const ImpactSide sb = sideOf(world, b, point);
        const double ra = cross(sa.arm, direction);
        const double rb = cross(sb.arm, direction);
        return sa.inverseMass + ra * ra * sa.inverseInertia + sb.inverseMass + rb * rb * sb.inverseInertia;
    };
    for (int turn = 0; turn < 200; ++turn) {
        for (std::size_t i = 0; i < 2; ++i) {
            Impulse& impulse = impulses[i];
            const double change = (impulse.wanted - speedAt(points[i]).dot(n)) / inverseMass(points[i], n);
            const double normal = std::max(impulse.normal + change, 0.0);
            push(points[i], n * (normal - impulse.normal));
            impulse.normal = normal;
            const Vec2 t = perp(n);
            const double limit = law.friction * impulse.normal;
            const double slow = speedAt(points[i]).dot(t) / inverseMass(points[i], t);
            const double tangent = std::clamp(impulse.tangent - slow, -limit, limit);
            push(points[i], t * (tangent - impulse.tangent));
            impulse.tangent = tangent;
        }
    }
    std::vector<PointImpulse> given;
    for (std::size_t i = 0; i < 2; ++i) given.push_back({points[i], impulses[i].normal, impulses[i].tangent});
    return given;
}

/// What the impulses did to the energy, by the speeds before and after them, and to whom.
void account(const WorldState& world, Meeting& meeting, const std::vector<PointImpulse>& given,
             const std::array<BodyMotion, 2>& before, const std::array<BodyMotion, 2>& after) {
    const ContactRecord& contact = world.contacts.contacts[meeting.contact];
    const Vec2 n = meeting.where.normal, t = perp(n);
    for (const PointImpulse& point : given) {
        const Vec2 va = 0.5 * (velocityAt(before[0], point.point) + velocityAt(after[0], point.point));
        const Vec2 vb = 0.5 * (velocityAt(before[1], point.point) + velocityAt(after[1], point.point));
        const Vec2 impulse = n * point.normal + t * point.tangent;
        meeting.normalImpulse += point.normal;
        meeting.tangentImpulse += point.tangent;
        meeting.friction += point.tangent * t.dot(vb - va);
        if (!world.bodies.isDynamic(contact.bodyA)) meeting.drivers += impulse.dot(va);
        if (!world.bodies.isDynamic(contact.bodyB)) meeting.drivers -= impulse.dot(vb);
        meeting.onA -= impulse;
    }
}

/// Of what the narrow phase did not see coming, the rules are asked where it meets.
bool isLetThrough(WorldState& world, const Meeting& meeting, const Flyer& a, const Flyer& b) {
    const ContactRecord& contact = world.contacts.contacts[meeting.contact];
    if (!contact.ruled || contact.verdict == Verdict::Solid) return false;
    const FlyingPair pair = shapesOf(world, contact, a, b);
    const Encounter e = encounterAt(pair.a, pair.b, *meeting.time);
    const ImpactSide sa{e.a.velocity, e.a.angularVelocity, 0, 0, e.distance.pointA - e.a.center};
    const ImpactSide sb{e.b.velocity, e.b.angularVelocity, 0, 0, e.distance.pointB - e.b.center};
    const Vec2 velocity =
        (sb.velocity + perp(sb.arm) * sb.angularVelocity) - (sa.velocity + perp(sa.arm) * sa.angularVelocity);
    return !isSolid(world, meeting.contact, {e.distance.normal, velocity, e.distance.separation});
}

/// Moves the two to where they meet and parts them. What they were before that; nothing when it was not found, for
/// they spin too fast.
std::optional<std::array<BodyMotion, 2>> part(WorldState& world, Meeting& meeting, Flyer& a, Flyer& b) {
    const ContactRecord& contact = world.contacts.contacts[meeting.contact];
    const double time = *meeting.time;
    const FlyingPair pair = shapesOf(world, contact, a, b);
    Encounter e = encounterAt(pair.a, pair.b, time);
    if (e.distance.separation > lostTouch || e.distance.separation < -lostWay) return std::nullopt;
    endFlight(world, a, e.a, time);
    endFlight(world, b, e.b, time);
    a.flight.from = e.a;
    b.flight.from = e.b;
    a.flight.time = b.flight.time = time;
    meeting.where = e.distance;
    meeting.approachSpeed = std::max(meeting.approachSpeed, e.closingSpeed);
    const ImpactLaw law{contact.restitution, contact.friction};
    const std::vector<Vec2> points = touchingPoints(world, contact, a, b, e.distance);
    std::vector<PointImpulse> given;
    if (points.size() == 2) {
        given = partFace(world, e.distance.normal, points, a, b, law);
    } else {
        const ImpactResult result =
            impact(sideOf(world, a, points[0]), sideOf(world, b, points[0]), e.distance.normal, law);
        apply(a, result.velocityA, result.angularVelocityA);
        apply(b, result.velocityB, result.angularVelocityB);
        given = {{points[0], result.normalImpulse, result.tangentImpulse}};
    }
    std::array<BodyMotion, 2> met{e.a, e.b};
    account(world, meeting, given, met, {a.flight.from, b.flight.from});
    if (!contact.shift.isZero(0)) {  // back to where it is
        met[1].center -= contact.shift;
        b.flight.from.center -= contact.shift;
    }
    return met;
}

void tell(WorldState& world, const Meeting& m) {
    if (!world.audit) return;
    const ContactRecord& contact = world.contacts.contacts[m.contact];
    const bool pushA = world.bodies.isDynamic(contact.bodyA), pushB = world.bodies.isDynamic(contact.bodyB);
    world.audit->note(&EnergyLedger::friction, m.friction);
    world.audit->note(&EnergyLedger::drivers, m.drivers);
    if (pushA != pushB) world.audit->note(&MomentumLedger::ground, pushA ? m.onA : Vec2(-m.onA));
}

void commit(WorldState& world, const std::vector<Flyer>& flyers, const std::vector<Meeting>& meetings,
            std::vector<Leg> legs, double dt) {
    for (const Flyer& f : flyers) {
        BodyRecord& record = world.bodies.record[f.body];
        if (record.type != BodyType::Dynamic) continue;  // a platform may be in many groups, and flies by itself
        BodyMotion end = fly(f.flight.from, f.flight.law, dt - f.flight.time);
        if (f.fields && !f.fields->steady) {
            end.velocity += f.fields->rest.velocity;
            end.angularVelocity += f.fields->rest.spin;
            world.fields.flights[record.flight] = *f.fields;
            FieldAccount whole = f.account;
            whole += f.fields->account;
            if (world.audit) world.audit->noteFieldFlight(whole);
        }
        legs.push_back({f.body, f.flight.from, end, f.flight.time, dt});
        moveTo(world, f.body, end);
        record.flown = true;
    }
    for (const Leg& leg : legs)
        if (world.audit) world.audit->noteFlight(world, leg.body, leg.from, leg.to, leg.end - leg.start);
    world.legs.insert(world.legs.end(), legs.begin(), legs.end());
    for (const Meeting& m : meetings) {
        if (m.normalImpulse == 0) continue;
        tell(world, m);
        ContactRecord& contact = world.contacts.contacts[m.contact];
        contact.memory[0].totalNormal = static_cast<float>(m.normalImpulse);
        contact.memory[0].totalTangent = static_cast<float>(m.tangentImpulse);
        contact.memoryStep = dt;
        if (contact.touching) world.ends.push_back({world.idOfShape(contact.proxyA), world.idOfShape(contact.proxyB)});
        world.begins.push_back({world.idOfShape(contact.proxyA), world.idOfShape(contact.proxyB),
                                world.def.wrap.place(m.where.pointA), m.where.normal, m.approachSpeed,
                                tileTouched(world, contact, m.where.pointA, m.where.normal)});
        if (m.approachSpeed > world.def.hitSpeed) world.hits.push_back(hitOf(world.begins.back()));
        contact.touching = true;
    }
}

}  // namespace

bool bouncesClear(const WorldState& world, const ContactRecord& contact, double dt) {
    if (contact.restitution <= 0) return false;
    const BodyMotion& a = world.bodies.motion[contact.bodyA];
    const BodyMotion b = shifted(world.bodies.motion[contact.bodyB], contact.shift);
    const Manifold manifold = world.graph.manifoldOf(contact);
    const Vec2 normal = a.rotation * Vec2(manifold.normal.cast<double>());
    const Vec2 pull =
        flightLawOf(world, contact.bodyA).acceleration.linear - flightLawOf(world, contact.bodyB).acceleration.linear;
    const double press = pull.dot(normal);
    for (int p = 0; p < manifold.count; ++p) {
        const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(p)];
        const Vec2 at = a.center + a.rotation * Vec2(point.position.cast<double>());
        const Vec2 relative = (b.velocity + perp(Vec2(at - b.center)) * b.angularVelocity) -
                              (a.velocity + perp(Vec2(at - a.center)) * a.angularVelocity);
        const double opening = relative.dot(normal);
        const double fall = std::max(press * static_cast<double>(point.separation), 0.0);
        const double speed = std::sqrt(opening * opening + 2 * fall);
        const bool overlapping = point.separation < -1e-4f && opening >= 0;  // only the solver pushes apart
        if (overlapping || 2 * contact.restitution * speed < press * dt) return false;
    }
    return true;
}

bool flyThroughImpacts(WorldState& world, std::span<const ContactIndex> contacts, double dt) {
    if (contacts.size() > largestGroup) return false;
    std::vector<Flyer> flyers;
    std::vector<Meeting> meetings;
    for (const ContactIndex index : contacts) {
        const ContactRecord& contact = world.contacts.contacts[index];
        Meeting meeting;
        meeting.contact = index;
        meeting.a = flyerOf(flyers, world, contact.bodyA);
        meeting.b = flyerOf(flyers, world, contact.bodyB);
        meetings.push_back(meeting);
    }
    const auto foresee = [&](Meeting& m) {
        m.time.reset();
        if (m.through) return;
        const ContactRecord& contact = world.contacts.contacts[m.contact];
        const FlyingPair pair = shapesOf(world, contact, flyers[m.a], flyers[m.b]);
        m.time = timeOfImpact(pair.a, pair.b, std::max(pair.a.time, pair.b.time), dt);
    };
    for (Meeting& m : meetings) foresee(m);
    std::vector<Leg> legs;
    const auto isDynamic = [&](std::size_t flyer) { return world.bodies.isDynamic(flyers[flyer].body); };
    for (std::size_t count = 0; count <= impactsPerBody * flyers.size(); ++count) {
        Meeting* next = nullptr;
        for (Meeting& m : meetings)
            if (m.time && (next == nullptr || *m.time < *next->time)) next = &m;
        if (next == nullptr) {
            commit(world, flyers, meetings, legs, dt);
            return true;
        }
        if (isLetThrough(world, *next, flyers[next->a], flyers[next->b])) {
            next->through = true;
            next->time.reset();
            continue;
        }
        const std::array<FlyingShape, 2> before{flyers[next->a].flight, flyers[next->b].flight};
        const std::optional<std::array<BodyMotion, 2>> met = part(world, *next, flyers[next->a], flyers[next->b]);
        if (!met) return false;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!isDynamic(i == 0 ? next->a : next->b)) continue;
            Flyer& flyer = flyers[i == 0 ? next->a : next->b];
            legs.push_back({flyer.body, before[i].from, (*met)[i], before[i].time, *next->time});
            flyOn(world, flyer, dt);
        }
        const auto concerns = [&](const Meeting& m, std::size_t f) { return isDynamic(f) && (m.a == f || m.b == f); };
        for (Meeting& m : meetings)
            if (concerns(m, next->a) || concerns(m, next->b)) foresee(m);
    }
    return false;
}

}  // namespace plumb
