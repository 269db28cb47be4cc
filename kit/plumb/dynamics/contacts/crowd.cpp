// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/crowd.h>

#include <cstddef>

namespace plumb {

namespace {

/// A body that overlaps deeply with so many others is in a crowd [-]. With n bodies at one point there are then a few
/// times n contacts in place of n^2 / 2: 3,000 bodies took a minute a step and 4 GB before, a second and 190 MB since.
constexpr std::uint32_t most = 8;
/// Two bodies overlap deeply if their centres are nearer than this share of both inradii: a disc of two thirds of the
/// inradius around the centre of mass lies in every convex shape [-].
constexpr double deepShare = 0.66;

}  // namespace

Crowd::Crowd(ContactStore& contacts, const BodyStore& bodies, const Space& space)
    : contacts_(contacts), bodies_(bodies), space_(space) {}

/// Asked by addNewPairs for each new pair, in the order of the shapes.
bool Crowd::leavesOut(const ShiftedShapes& pair) {
    const bool inside = isInside(pair);
    if (inside)
        contacts_.leftOut.push_back(pair.shapes);
    else
        noteAdded(pair);
    return inside;
}

void Crowd::noteAdded(const ShiftedShapes& pair) {
    for (const ProxyId proxy : {pair.shapes.a, pair.shapes.b}) ++overlaps_[space_.filterKey(proxy).owner].added;
}

/// Goes through the pairs that were left out, before the new ones of a step: O(pairs) while there is a crowd. The space
/// does not report them again, as their bounds overlap all the time.
void Crowd::takeBack(FunctionRef<void(const ShiftedShapes&)> add) {
    const auto staysOut = [&](const Pair& shapes) {
        bool stays = false;
        forEachOverlap(shapes, [&](const ShiftedShapes& pair) {
            const bool inside = isInside(pair);
            stays = stays || inside;
            if (inside || findContact(contacts_, bodies_, space_, pair) != none) return;
            noteAdded(pair);
            add(pair);
        });
        return stays;
    };
    std::vector<Pair>& pairs = contacts_.leftOut;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Pair pair = pairs[i];
        if (staysOut(pair)) pairs[kept++] = pair;
    }
    pairs.resize(kept);
}

/// Are both of its bodies deep in a crowd?
bool Crowd::isInside(const ShiftedShapes& pair) {
    if (overlaps_.empty()) overlaps_.resize(bodies_.record.size());
    return isCrowded(space_.filterKey(pair.shapes.a).owner) && isCrowded(space_.filterKey(pair.shapes.b).owner);
}

/// A contact of shapes that overlap is in the solver, or is new, and each new one adds one overlap at the most. So
/// bodies with few contacts are passed without a count, and a count is repeated only when new contacts could change it.
bool Crowd::isCrowded(BodyIndex body) {
    Overlaps& o = overlaps_[body];
    if (o.inContact >= most) return true;
    const std::uint32_t possible =
        o.isCounted ? o.inContact + (o.added - o.counted) : bodies_.links[body].solverContacts + o.added;
    if (possible < most || !isOne(body)) return false;
    o.inContact = overlapsInContact(body);
    o.counted = o.added;
    o.isCounted = true;
    return o.inContact >= most;
}

/// Visits a pair if its bounds overlap still; in a world that wraps, with each shift with which they do.
template <class Visit>
void Crowd::forEachOverlap(const Pair& shapes, Visit&& visit) const {
    if (!mayPair(space_.filterKey(shapes.a), space_.filterKey(shapes.b))) return;
    if (bodies_.wrap.any())
        space_.forEachShift(space_.box(shapes.a), space_.box(shapes.b), [&](const Vec2& shift) {
            visit(ShiftedShapes{shapes, shift});
        });
    else if (space_.boxesOverlap(shapes.a, shapes.b))
        visit(ShiftedShapes{shapes});
}

std::uint32_t Crowd::overlapsInContact(BodyIndex body) const {
    std::uint32_t count = 0;
    anyContact(bodies_, contacts_, body, [&](ContactIndex index) {
        const ContactRecord& contact = contacts_[index];
        if (overlap(contact.bodyA, contact.bodyB, contact.shift)) ++count;
        return count == most;
    });
    return count;
}

/// Bodies of several shapes may have their centre outside of them.
bool Crowd::isOne(BodyIndex body) const {
    return bodies_.isDynamic(body) && bodies_.links[body].proxies.size() == 1;
}

bool Crowd::overlap(BodyIndex a, BodyIndex b, const Vec2& shift) const {
    if (!isOne(a) || !isOne(b)) return false;
    const double deep = deepShare * (bodies_.record[a].inradius + bodies_.record[b].inradius);
    return (bodies_.motion[b].center + shift - bodies_.motion[a].center).squaredNorm() < deep * deep;
}

}  // namespace plumb
