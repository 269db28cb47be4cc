// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/contact_rules.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

/// Cosine of the largest angle between a contact normal and the one-way direction at which the shape is solid [-]: 60
/// degrees. Test: "a one-way line is solid up to 59 degrees off its direction, and not at 61"
constexpr double minCosineSolid = 0.5;
/// Cosine of the largest angle, from the opposite of the one-way direction, at which a body lands on the end of a line
/// and does not pass it [-].
constexpr double minCosineLanding = 0.866;
/// A contact is at a line's end if its normal is tilted outwards by more than this; jitter at rest is smaller [rad].
constexpr double leaning = 0.02;
/// A body that overlaps by no more than this can still become solid: it has just come through, or is at a seam [m].
/// Test: "a one-way floor bears a box that is 4.9 mm deep in it, and lets one fall that is 5.1 mm deep"
constexpr double slop = 5e-3;

/// A shape, and how the other shape approaches it.
struct Side {
    const Proxy& own;
    const Proxy& other;
    Vec2 normal;    ///< from the own shape to the other
    Vec2 velocity;  ///< of the other shape, relative to the own one [m/s]
};

/// A rule sees its own shape first, whichever of the two is A.
std::array<Side, 2> sidesOf(const Proxy& a, const Proxy& b, const Face& face) {
    return {Side{a, b, face.normal, face.velocity}, Side{b, a, -face.normal, -face.velocity}};
}

/// Is the contact at an end of a line segment that has no neighbour there?
bool isAtEnd(const Side& side, const Rot& rotation) {
    const auto* line = std::get_if<Segment>(&side.own.def.shape);
    if (line == nullptr) return false;
    const Vec2 along = rotation * Vec2(line->end - line->start);
    const double lean = side.normal.dot(along);
    if (std::fabs(lean) < leaning * along.norm()) return false;
    return !(lean > 0 ? line->after : line->before);
}

/// Does the other shape move against the one-way direction, within 30 degrees? One that comes from the side, partly
/// below the line, passes the end.
bool comesDown(const Side& side, const Vec2& open) {
    return -side.velocity.dot(open) >= minCosineLanding * side.velocity.norm() * open.norm();
}

}  // namespace

Face faceOf(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold) {
    const ManifoldPoint& first = manifold.points[0];
    const ManifoldPoint& second = manifold.points[1];
    const ManifoldPoint& nearest = manifold.count > 1 && second.separation < first.separation ? second : first;
    const BodyMotion& ma = bodies.motion[contact.bodyA];
    const BodyMotion mb = shifted(bodies.motion[contact.bodyB], contact.shift);
    const Vec2 point = ma.center + ma.rotation * Vec2(nearest.position.cast<double>());
    return {ma.rotation * Vec2(manifold.normal.cast<double>()), velocityAt(mb, point) - velocityAt(ma, point),
            static_cast<double>(nearest.separation)};
}

bool hasRule(const ShapeDef& shape) {
    return shape.rule != nullptr || shape.oneWay.has_value();
}

bool rulesAdmit(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face) {
    const std::array<Side, 2> sides = sidesOf(a, b, face);
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        if (side.own.def.rule == nullptr) return true;
        ContactCandidate question;
        question.normal = side.normal;
        question.localNormal = bodies.motion[side.own.owner].rotation.inverse() * side.normal;
        question.velocity = side.velocity;
        question.separation = face.separation;
        question.tag = side.own.def.tag;
        question.otherTag = side.other.def.tag;
        return side.own.def.rule(question);
    });
}

bool comesFromOpenSide(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face, bool wasSolid) {
    const std::array<Side, 2> sides = sidesOf(a, b, face);
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        if (!side.own.def.oneWay) return true;
        const Rot& rotation = bodies.motion[side.own.owner].rotation;
        const Vec2 open = rotation * *side.own.def.oneWay;
        const bool above = side.normal.dot(open) >= minCosineSolid * open.norm();
        // What stands on the shape is pressed in by loads: depth and the line's end count only for what arrives.
        if (!above || wasSolid) return above;
        return face.separation >= -slop && (!isAtEnd(side, rotation) || comesDown(side, open));
    });
}

bool isSolid(ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
             const Face& face) {
    ContactRecord& contact = contacts[index];
    const Proxy& a = space[contact.proxyA];
    const Proxy& b = space[contact.proxyB];
    // Rules are user code, and are called once for each time the two come near. Test: "a rule is asked once as two come
    // near, with what it may go by, and its answer holds until they part"
    if (contact.verdict == Verdict::Open) {
        contacts.withVerdict.push_back(index);
        if (!rulesAdmit(bodies, a, b, face)) contact.verdict = Verdict::Refused;
    }
    if (contact.verdict == Verdict::Refused) return false;
    const bool was = contact.verdict == Verdict::Solid;
    const bool solid = comesFromOpenSide(bodies, a, b, face, was);
    contact.verdict = solid ? Verdict::Solid : Verdict::Through;
    return solid;
}

StepList<ContactIndex> findLetThrough(ContactStore& contacts, const ContactGraph& graph, const BodyStore& bodies,
                                      const Space& space) {
    StepList<ContactIndex> through;
    for (const ContactIndex index : contacts.withVerdict) {
        const ContactRecord& contact = contacts[index];
        if (!contact.isSolved()) continue;
        const Manifold manifold = graph.manifoldOf(contact);
        if (manifold.count == 0) continue;
        if (!isSolid(contacts, bodies, space, index, faceOf(bodies, contact, manifold))) through.push_back(index);
    }
    return through;
}

/// A contact has parted if it had no manifold in this step; only then may a rule decide anew. O(contacts with a rule).
void dropVerdicts(ContactStore& contacts, const ContactGraph& graph) {
    std::erase_if(contacts.withVerdict, [&](ContactIndex index) {
        ContactRecord& contact = contacts[index];
        const bool parted =
            contact.isSolved() ? graph.manifoldOf(contact).count == 0 : contact.isNear() && !contact.met;
        if (parted) contact.verdict = Verdict::Open;
        return parted;
    });
}

}  // namespace plumb
