// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/crowd.h>

#include <cstddef>

namespace plumb {

namespace {

/// A body that overlaps deeply with so many others is in a crowd.
constexpr std::uint32_t most = 16;
/// Two bodies overlap deeply if their centres are nearer than this share of both inradii: a disc of two thirds of the
/// inradius around the centre of mass lies in every convex shape [-].
constexpr double deepShare = 0.66;

}  // namespace

Crowd::Crowd(ContactStore& contacts, const BodyStore& bodies, const Space& space)
    : contacts_(contacts), bodies_(bodies), space_(space) {
    if (!contacts.leftOut.empty()) countLeftOut();
}

bool Crowd::leavesOut(const ShiftedShapes& pair) {
    if (!isInside(pair)) return false;
    contacts_.leftOut.push_back(pair.shapes);
    return true;
}

void Crowd::takeBack(FunctionRef<void(const ShiftedShapes&)> add) {
    const auto staysOut = [&](const Pair& shapes) {
        bool stays = false;
        forEachOverlap(shapes, [&](const ShiftedShapes& pair) {
            if (isInside(pair))
                stays = true;
            else if (findContact(contacts_, bodies_, space_, pair) == none)
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

/// Are both of its bodies deep in a crowd?
bool Crowd::isInside(const ShiftedShapes& pair) {
    const BodyIndex a = space_.filterKey(pair.shapes.a).owner, b = space_.filterKey(pair.shapes.b).owner;
    if (bodies_.links[a].contacts < most || bodies_.links[b].contacts < most) return false;
    return isCrowded(a) && isCrowded(b);
}

/// Within a step a body's overlaps grow only.
bool Crowd::isCrowded(BodyIndex body) {
    if (overlaps_.empty()) overlaps_.assign(bodies_.record.size(), 0);
    std::uint32_t& overlaps = overlaps_[body];
    if (overlaps < most && overlaps + overlapsInContact(body) >= most) overlaps = most;
    return overlaps >= most;
}

void Crowd::countLeftOut() {
    overlaps_.assign(bodies_.record.size(), 0);
    for (const Pair& shapes : contacts_.leftOut)
        forEachOverlap(shapes, [&](const ShiftedShapes& pair) {
            const BodyIndex a = space_.filterKey(shapes.a).owner, b = space_.filterKey(shapes.b).owner;
            if (!overlap(a, b, pair.shift)) return;
            ++overlaps_[a];
            ++overlaps_[b];
        });
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
bool Crowd::overlap(BodyIndex a, BodyIndex b, const Vec2& shift) const {
    const auto isOne = [this](BodyIndex body) {
        return bodies_.isDynamic(body) && bodies_.links[body].proxies.size() == 1;
    };
    if (!isOne(a) || !isOne(b)) return false;
    const double deep = deepShare * (bodies_.record[a].inradius + bodies_.record[b].inradius);
    return (bodies_.motion[b].center + shift - bodies_.motion[a].center).squaredNorm() < deep * deep;
}

}  // namespace plumb
