// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/pairs.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// Upper limit of friction: more makes no difference, and might overflow the solver's floats [-].
constexpr double roughest = 1e6;

/// If the two materials name different rules, the later one in Mix counts. So the result does not depend on which shape
/// is A. Test: "friction 0.2 on 0.8 is 0.5, 0.4, 0.2, 0.16 or 0.8 by the pair's rule, of two the later"
double mixed(double a, double b, Mix ruleA, Mix ruleB) {
    switch (std::max(ruleA, ruleB)) {
        case Mix::Average: return 0.5 * (a + b);
        case Mix::GeometricMean: return std::sqrt(a * b);
        case Mix::Minimum: return std::min(a, b);
        case Mix::Product: return a * b;
        case Mix::Maximum: return std::max(a, b);
    }
    return 0;
}

/// The larger rounding radius of the two: that shape rolls on the other.
double roundingOf(const Proxy& a, const Proxy& b) {
    return static_cast<double>(std::max(a.convex.radius, b.convex.radius));
}

/// A record for a pair that has no contact yet. Its impulses are 0 and its verdict is open.
ContactRecord contactOf(const ContactStore& contacts, const Space& space, const ShiftedShapes& pair) {
    const Proxy& a = space[pair.shapes.a];
    const Proxy& b = space[pair.shapes.b];
    ContactRecord contact;
    contact.proxyA = pair.shapes.a;
    contact.proxyB = pair.shapes.b;
    contact.bodyA = a.owner;
    contact.bodyB = b.owner;
    contact.shift = pair.shift;
    // Two boxes have their own near list, colours and code, which need no corners: they are never mixed with other
    // pairs.
    const auto isBox = [&](ProxyId proxy) { return contacts.boxes[proxy].kind == BoxOutline::Kind::Box; };
    contact.boxes = isBox(pair.shapes.a) && isBox(pair.shapes.b);
    contact.ruled = hasRule(a.def) || hasRule(b.def);
    mixMaterials(space, contact);
    return contact;
}

}  // namespace

ShiftedShapes inOrder(ProxyId a, ProxyId b, const Vec2& shift) {
    return a < b ? ShiftedShapes{{a, b}, shift} : ShiftedShapes{{b, a}, -shift};
}

bool mayTouch(const BodyStore& bodies, const Space& space, const ShiftedShapes& pair) {
    const Proxy& first = space[pair.shapes.a];
    const Proxy& second = space[pair.shapes.b];
    if (first.def.sensor || second.def.sensor) return false;
    const BodyIndex a = first.owner, b = second.owner;
    return (bodies.isDynamic(a) || bodies.isDynamic(b)) && !bodies.areKeptApart(a, b);
}

/// Walks along the contacts of one body: O(its contacts). There is no table of pairs, because few ask: edits, crowds,
/// searches for walls along a path, and what was deflected. The pair may be in either order: a search along a path
/// begins at the body that moves.
ContactIndex findContact(const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                         const ShiftedShapes& pair) {
    const ProxyId a = pair.shapes.a, b = pair.shapes.b;
    const BodyIndex owner = space[a].owner;
    const BodyIndex body = bodies.isDynamic(owner) ? owner : space[b].owner;  // a wall has far more contacts
    ContactIndex found = none;
    forEachContact(bodies, contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = contacts[index];
        if ((contact.proxyA == a && contact.proxyB == b && contact.shift == pair.shift) ||
            (contact.proxyA == b && contact.proxyB == a && contact.shift == -pair.shift))
            found = index;
    });
    return found;
}

ContactIndex addContact(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair) {
    const ContactIndex index = contacts.add(bodies, contactOf(contacts, space, pair));
    const BodyIndex a = space[pair.shapes.a].owner, b = space[pair.shapes.b].owner;
    if (bodies.record[a].awake || bodies.record[b].awake) contacts.addNear(index);
    return index;
}

ContactIndex addEarlyContact(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair) {
    // The broad phase compares with the boxes of its last search, and will report this pair as new. addNewPairs looks
    // it up in this list: else the pair would have two contacts, and be solved twice.
    contacts.early.push_back(pair.shapes);
    return addContact(contacts, bodies, space, pair);
}

PairKind addPair(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair) {
    const Proxy& first = space[pair.shapes.a];
    const Proxy& second = space[pair.shapes.b];
    if (first.def.sensor || second.def.sensor) return PairKind::AtSensor;
    if (!mayTouch(bodies, space, pair)) return PairKind::Nothing;
    addContact(contacts, bodies, space, pair);
    const BodyIndex a = first.owner, b = second.owner;
    // What is put into a sleeping body must wake it: nothing else would collide the two. Two dynamic bodies that sleep
    // need no look: each fell asleep where it is. Test: "a wall set into a sleeping box wakes it and pushes it out,
    // once for each time it is set there"
    const bool asleep = !bodies.record[a].awake && !bodies.record[b].awake;
    return asleep && !(bodies.isDynamic(a) && bodies.isDynamic(b)) ? PairKind::AtSleeper : PairKind::Contact;
}

/// For two bodies whose joint is removed or changed, so that they may touch again. It asks the boxes of the last
/// search, not the present ones: what has come near since then is reported by the next search, and would get a second
/// contact.
std::vector<ShiftedShapes> pairsOfBodies(const BodyStore& bodies, const Space& space, BodyIndex a, BodyIndex b) {
    std::vector<ShiftedShapes> pairs;
    if (!bodies.record[a].enabled || !bodies.record[b].enabled) return pairs;
    const auto isSensor = [&space](ProxyId proxy) { return space[proxy].def.sensor; };
    for (const ProxyId pa : bodies.links[a].proxies)
        for (const ProxyId pb : bodies.links[b].proxies)
            if (!isSensor(pa) && !isSensor(pb) && mayPair(space[pa], space[pb]))
                space.forEachPreviousShift(pa, pb, [&](const Vec2& shift) { pairs.push_back(inOrder(pa, pb, shift)); });
    return pairs;
}

/// For a shape whose filter has changed. It asks the boxes of the last search, as pairsOfBodies does.
std::vector<ShiftedShapes> pairsOfShape(const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                                        ProxyId proxy) {
    struct Other {
        ProxyId proxy;
        Vec2 shift;
    };
    std::vector<Other> others;
    space.query(space.box(proxy), [&](ProxyId other, const Vec2& shift) {
        if (mayPair(space[proxy], space[other]) && space.previousBoxesOverlap(proxy, other, shift))
            others.push_back({other, shift});
    });
    // The tree finds shapes in an order that depends on everything in the world; contacts are made in the order of
    // their shapes. In a world that wraps, it may find one at the same shift more than once.
    sortOnceBy(others, [](const Other& one) { return std::tuple(one.proxy, one.shift.x(), one.shift.y()); });
    std::vector<ShiftedShapes> pairs;
    for (const Other& other : others) {
        const ShiftedShapes pair = inOrder(proxy, other.proxy, other.shift);
        if (findContact(contacts, bodies, space, pair) == none) pairs.push_back(pair);
    }
    return pairs;
}

void mixMaterials(const Space& space, ContactRecord& contact) {
    const Proxy& a = space[contact.proxyA];
    const Proxy& b = space[contact.proxyB];
    const Material& ma = a.def.material;
    const Material& mb = b.def.material;
    contact.friction = std::min(mixed(ma.friction, mb.friction, ma.frictionMix, mb.frictionMix), roughest);
    contact.restitution = mixed(ma.restitution, mb.restitution, ma.restitutionMix, mb.restitutionMix);
    const double reach = std::max(ma.rollingResistance, mb.rollingResistance) * roundingOf(a, b);
    contact.rollingArm = static_cast<float>(std::min(reach, roughest));
    contact.surfaceSpeed = static_cast<float>(ma.surfaceSpeed + mb.surfaceSpeed);
}

}  // namespace plumb
