// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/impact_group.h>

#include <algorithm>
#include <array>
#include <optional>

#include <plumb/dynamics/bodies/time_of_impact.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/fields/field_flight.h>
#include <plumb/dynamics/impacts/face_impact.h>

namespace plumb {

namespace {

/// A group with more impacts per body than this in one step is a pile, and is left to the solver.
constexpr std::size_t impactsPerBody = 16;

/// A group with more contacts than this is left to the solver, too: the search for each impact checks all of them.
constexpr std::size_t largestGroup = 200;

/// Where a pair should meet, a larger gap or a deeper overlap than this shows that the search has failed [m].
constexpr double widestTouch = 1e-6;
constexpr double deepestTouch = 1e-3;

/// A body of the group, since its last impact.
struct GroupBody {
    BodyIndex body = noBody;
    MovingShape flight;                 ///< its shape is set for each contact
    std::optional<FieldFlight> fields;  ///< effect of fields from the last impact on
    FieldAccount account;               ///< effect of fields before the last impact
};

/// A contact between two bodies of the group, and when they meet next.
struct GroupPair {
    ContactIndex contact = 0;
    std::size_t a = 0, b = 0;
    std::optional<double> time;
    bool through = false;  ///< a rule or a one-way side lets it pass
    double approachSpeed = 0, normalImpulse = 0, tangentImpulse = 0;
    double friction = 0, drivers = 0;  ///< energy from friction, and from bodies that impulses do not move [J]
    Vec2 onA{0, 0};                    ///< total impulse on A [N s]
    Distance where;
};

/// The states of the two bodies of a pair, A first.
using TwoMotions = std::array<BodyMotion, 2>;

/// The two shapes of a contact, B as the periodic image that meets A.
struct MovingPair {
    MovingShape a, b;
};

class ImpactGroup {
public:
    ImpactGroup(const ImpactStores& stores, std::span<const ContactIndex> contacts, double dt)
        : stores_(stores), dt_(dt) {
        for (const ContactIndex index : contacts) {
            GroupPair pair;
            pair.contact = index;
            pair.a = find(stores_.contacts[index].bodyA);
            pair.b = find(stores_.contacts[index].bodyB);
            pairs_.push_back(pair);
        }
        for (GroupPair& pair : pairs_) predict(pair);
    }

    /// Solves impact after impact to the end of the step; false if there are too many, or if one cannot be solved.
    bool run() {
        for (std::size_t count = 0; count <= impactsPerBody * bodies_.size(); ++count) {
            GroupPair* next = nullptr;
            for (GroupPair& pair : pairs_)
                if (pair.time && (next == nullptr || *pair.time < *next->time)) next = &pair;
            if (next == nullptr) return true;
            if (isLetThrough(*next)) {
                next->through = true;
                next->time.reset();
                continue;
            }
            if (!solve(*next)) return false;
            for (GroupPair& pair : pairs_)
                if (concerns(pair, next->a) || concerns(pair, next->b)) predict(pair);
        }
        return false;
    }

    void store(double hitSpeed, Impacts& impacts) {
        for (const GroupBody& body : bodies_) storeBody(body);
        if (stores_.observer != nullptr)
            for (const TrajectorySegment& s : segments_)
                stores_.observer->noteFlight(s.body, s.from, s.to, s.end - s.start);
        impacts.trajectories.insert(impacts.trajectories.end(), segments_.begin(), segments_.end());
        for (const GroupPair& pair : pairs_)
            if (pair.normalImpulse != 0) storePair(pair, hitSpeed, impacts.touches);
    }

private:
    std::size_t find(BodyIndex body) {
        const auto found =
            std::find_if(bodies_.begin(), bodies_.end(), [body](const GroupBody& b) { return b.body == body; });
        if (found != bodies_.end()) return static_cast<std::size_t>(found - bodies_.begin());
        const BodyStore& store = stores_.bodies;
        GroupBody added;
        added.body = body;
        added.flight.localCenter = store.record[body].localCenter;
        added.flight.boundingRadius = store.record[body].boundingRadius;
        added.flight.from = store.motion[body];
        added.flight.law = flightLawOf(store, body);
        if (const std::uint32_t flight = store.step[body].flight; flight != none)
            added.fields = FieldFlight{store.flights[flight], stores_.fields.accounts[flight].account};
        bodies_.push_back(added);
        return bodies_.size() - 1;
    }

    bool isDynamic(std::size_t body) const { return stores_.bodies.isDynamic(bodies_[body].body); }
    bool concerns(const GroupPair& pair, std::size_t body) const {
        return isDynamic(body) && (pair.a == body || pair.b == body);
    }
    static bool hasVaryingFields(const GroupBody& body) { return body.fields && !body.fields->flight.steady; }

    void predict(GroupPair& pair) const {
        pair.time.reset();
        if (pair.through) return;
        const MovingPair shapes = shapesOf(pair);
        pair.time = timeOfImpact(shapes.a, shapes.b, std::max(shapes.a.time, shapes.b.time), dt_);
    }

    MovingPair shapesOf(const GroupPair& pair) const {
        const ContactRecord& contact = stores_.contacts[pair.contact];
        MovingPair shapes{bodies_[pair.a].flight, bodies_[pair.b].flight};
        shapes.a.shape = &stores_.space[contact.proxyA].def.shape;
        shapes.b.shape = &stores_.space[contact.proxyB].def.shape;
        shapes.b.from.center += contact.shift;
        return shapes;
    }

    /// May the two pass through each other? If the narrow phase has not predicted the contact, the rules are evaluated
    /// here, at the place where the two meet.
    bool isLetThrough(const GroupPair& pair) const {
        const ContactRecord& contact = stores_.contacts[pair.contact];
        if (!contact.ruled || contact.verdict == Verdict::Solid) return false;
        const MovingPair shapes = shapesOf(pair);
        const Encounter e = encounterAt(shapes.a, shapes.b, *pair.time);
        const Vec2 velocity = velocityAt(e.b, e.distance.pointB) - velocityAt(e.a, e.distance.pointA);
        const Face face{e.distance.normal, velocity, e.distance.separation};
        return !isSolid(stores_.contacts, stores_.bodies, stores_.space, pair.contact, face);
    }

    /// Moves the two bodies to where they meet and applies the impact. False if that place was not found because they
    /// spin too fast.
    bool solve(GroupPair& pair) {
        const std::array<MovingShape, 2> before{bodies_[pair.a].flight, bodies_[pair.b].flight};
        const std::optional<TwoMotions> met = part(pair);
        if (!met) return false;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t number = i == 0 ? pair.a : pair.b;
            if (!isDynamic(number)) continue;
            GroupBody& body = bodies_[number];
            segments_.push_back({body.body, before[i].from, (*met)[i], before[i].time, *pair.time});
            renewFields(body);
        }
        return true;
    }

    /// Applies the impact to the two bodies. Returns their states before it; empty if they do not meet at pair.time.
    std::optional<TwoMotions> part(GroupPair& pair) {
        const ContactRecord& contact = stores_.contacts[pair.contact];
        const double time = *pair.time;
        const MovingPair shapes = shapesOf(pair);
        Encounter e = encounterAt(shapes.a, shapes.b, time);
        if (e.distance.separation > widestTouch || e.distance.separation < -deepestTouch) return std::nullopt;
        GroupBody& a = bodies_[pair.a];
        GroupBody& b = bodies_[pair.b];
        endFields(a, e.a, time);
        endFields(b, e.b, time);
        a.flight.time = b.flight.time = time;
        pair.where = e.distance;
        pair.approachSpeed = std::max(pair.approachSpeed, e.closingSpeed);
        const std::vector<Vec2> points =
            touchingPoints(stores_.space[contact.proxyA].convex, e.a, stores_.space[contact.proxyB].convex, e.b,
                           e.distance, std::max(a.flight.boundingRadius, b.flight.boundingRadius));
        ImpactBody parted[] = {impactBody(a, e.a), impactBody(b, e.b)};
        const std::vector<PointImpulse> given =
            solveImpact(points, e.distance.normal, {contact.restitution, contact.friction}, parted[0], parted[1]);
        a.flight.from = parted[0].motion;
        b.flight.from = parted[1].motion;
        TwoMotions met{e.a, e.b};
        addImpulses(pair, given, met, {a.flight.from, b.flight.from});
        if (!contact.shift.isZero(0)) {  // back from the image to B's own place
            met[1].center -= contact.shift;
            b.flight.from.center -= contact.shift;
        }
        return met;
    }

    ImpactBody impactBody(const GroupBody& body, const BodyMotion& motion) const {
        const BodyRecord& record = stores_.bodies.record[body.body];
        return {motion, record.inverseMass, record.inverseInertia};
    }

    /// Corrects the velocity at the end of a free motion with varying fields: the law gives the right place, but only
    /// nearly the right velocity.
    void endFields(GroupBody& body, BodyMotion& at, double time) {
        if (!hasVaryingFields(body)) return;
        const double duration = time - body.flight.time;
        const FieldFlight done = flightFrom(stores_.fields, stores_.bodies, stores_.space, body.fields->flight,
                                            body.flight.from, body.flight.time, duration);
        const BodyMotion end = moveFreely(body.flight.from, done.flight.law, duration);
        at.velocity = end.velocity + done.flight.rest.velocity;
        at.angularVelocity = end.angularVelocity + done.flight.rest.spin;
        body.account += done.account;
    }

    /// Predicts the effect of fields again, from the body's present state on.
    void renewFields(GroupBody& body) {
        if (!hasVaryingFields(body)) return;
        body.fields = flightFrom(stores_.fields, stores_.bodies, stores_.space, body.fields->flight, body.flight.from,
                                 body.flight.time, dt_ - body.flight.time);
        body.flight.law = body.fields->flight.law;
    }

    /// Adds the impulses of an impact and their work, computed from the mean of the speeds before and after.
    void addImpulses(GroupPair& pair, const std::vector<PointImpulse>& given, const TwoMotions& before,
                     const TwoMotions& after) const {
        const ContactRecord& contact = stores_.contacts[pair.contact];
        const Vec2 n = pair.where.normal, t = perp(n);
        for (const PointImpulse& point : given) {
            const Vec2 va = 0.5 * (velocityAt(before[0], point.point) + velocityAt(after[0], point.point));
            const Vec2 vb = 0.5 * (velocityAt(before[1], point.point) + velocityAt(after[1], point.point));
            const Vec2 impulse = n * point.normal + t * point.tangent;
            pair.normalImpulse += point.normal;
            pair.tangentImpulse += point.tangent;
            pair.friction += point.tangent * t.dot(vb - va);
            if (!stores_.bodies.isDynamic(contact.bodyA)) pair.drivers += impulse.dot(va);
            if (!stores_.bodies.isDynamic(contact.bodyB)) pair.drivers -= impulse.dot(vb);
            pair.onA -= impulse;
        }
    }

    void storeBody(const GroupBody& body) {
        BodyStore& store = stores_.bodies;
        if (!store.isDynamic(body.body)) return;  // a kinematic body may be in many groups, and moves by itself
        BodyMotion end = moveFreely(body.flight.from, body.flight.law, dt_ - body.flight.time);
        if (hasVaryingFields(body)) {
            end.velocity += body.fields->flight.rest.velocity;
            end.angularVelocity += body.fields->flight.rest.spin;
            const std::uint32_t flight = store.step[body.body].flight;
            store.flights[flight] = body.fields->flight;
            FieldAccount& account = stores_.fields.accounts[flight].account;
            account = body.account;
            account += body.fields->account;
            if (stores_.observer != nullptr) stores_.observer->noteFieldFlight(flight);
        }
        segments_.push_back({body.body, body.flight.from, end, body.flight.time, dt_});
        moveTo(store, body.body, end);
        store.step[body.body].movedBy = MovedBy::Impacts;
    }

    void storePair(const GroupPair& pair, double hitSpeed, TouchEvents& touches) {
        ContactRecord& contact = stores_.contacts[pair.contact];
        if (stores_.observer != nullptr) report(pair, contact);
        contact.memory[0].totalNormal = static_cast<float>(pair.normalImpulse);
        contact.memory[0].totalTangent = static_cast<float>(pair.tangentImpulse);
        contact.memoryStep = dt_;
        if (contact.touching) touches.ends.push_back({contact.proxyA, contact.proxyB});
        const ShapeTouch touch{contact.proxyA,    contact.proxyB,    contact.shift,
                               pair.where.pointA, pair.where.normal, pair.approachSpeed};
        touches.begins.push_back(touch);
        if (pair.approachSpeed > hitSpeed) touches.hits.push_back(touch);
        contact.touching = true;
    }

    void report(const GroupPair& pair, const ContactRecord& contact) const {
        const bool pushA = stores_.bodies.isDynamic(contact.bodyA), pushB = stores_.bodies.isDynamic(contact.bodyB);
        Vec2 ground(0, 0);
        if (pushA != pushB) ground = pushA ? pair.onA : Vec2(-pair.onA);
        stores_.observer->noteImpact(pair.friction, pair.drivers, ground);
    }

    const ImpactStores& stores_;
    double dt_;
    std::vector<GroupBody> bodies_;
    std::vector<GroupPair> pairs_;
    Trajectories segments_;
};

}  // namespace

bool moveThroughImpacts(const ImpactStores& stores, std::span<const ContactIndex> contacts, double dt, double hitSpeed,
                        Impacts& impacts) {
    if (contacts.size() > largestGroup) return false;
    ImpactGroup group(stores, contacts, dt);
    if (!group.run()) return false;
    group.store(hitSpeed, impacts);
    return true;
}

}  // namespace plumb
