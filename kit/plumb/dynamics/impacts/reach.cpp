// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/reach.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/math/detail/sorting.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// If more shapes than this are in the box around the rest of a flight, it is so long that no contacts are made for
/// them [-]. The body is still stopped at walls, by stopFlights, which follows the impacts; other bodies it may pass.
/// Test: "a struck ball meets another one past 190 shapes, and passes it past 210"
constexpr std::size_t mostShapes = 200;

auto rankOf(const std::pair<ProxyId, Vec2>& met) {
    return std::tuple(met.first, met.second.x(), met.second.y());
}

}  // namespace

/// Cheap for most impacts: a body that stays within its bounds costs one box. Two bodies that have both left their
/// bounds do not find each other in the space, which still has their old bounds; so the new boxes are kept in leaving_,
/// and compared one by one.
void Reach::extend(const FlyingBody& body, StepList<ContactIndex>& added) {
    const Space& space = stores_.space;
    for (const ProxyId proxy : stores_.bodies.links[body.body].proxies) {
        const Aabb swept = sweptBoxOf(body, proxy);
        if (contains(space.box(proxy), swept)) continue;
        // What goes around a world that wraps meets others only at the places where steps begin, see predictedShift.
        if (stores_.bodies.wrap.isExceededBy(swept.upper - swept.lower)) continue;
        StepList<std::pair<ProxyId, Vec2>> found;
        space.query(swept, [&](ProxyId other, const Vec2& shift) { found.emplace_back(other, shift); });
        for (const Leaving& shape : leaving_) {
            const Vec2 shift = stores_.bodies.wrap.shiftNear(shape.box.lower, swept.lower);
            if (overlap(swept, {shape.box.lower + shift, shape.box.upper + shift}))
                found.emplace_back(shape.proxy, shift);
        }
        if (found.size() > mostShapes) continue;
        sortBy(found, rankOf);  // the space's order depends on what is far away, too
        for (const auto& [other, shift] : found) meet(proxy, other, shift, added);
        leaving_.push_back({proxy, swept});
    }
}

/// The bounds of a shape from its body's last impact to the end of the step. A point's path differs from the straight
/// line between its ends by at most a t^2 / 8, and by r turn^2 / 8 because of rotation.
Aabb Reach::sweptBoxOf(const FlyingBody& body, ProxyId proxy) const {
    const Shape& shape = stores_.space[proxy].def.shape;
    const MovingShape& flight = body.flight;
    const double left = dt_ - flight.time;
    const BodyMotion end = moveFreely(flight.from, flight.law, left);
    const auto boxAt = [&](const BodyMotion& motion) {
        return aabbOf(shape, {motion.center - motion.rotation * flight.localCenter, motion.rotation});
    };
    const double turn = std::fabs(end.angle - flight.from.angle);
    const double pull = flight.law.acceleration.linear.norm() + flight.law.linearDamping * flight.from.velocity.norm();
    const double swing = turningRadiusOf(shape, flight.localCenter) * std::min(0.125 * turn * turn, 2.0);
    return inflate(merge(boxAt(flight.from), boxAt(end)), 0.125 * pull * left * left + swing);
}

/// The contact is noted as early: the search for pairs in the next step will find the same pair, and must not add a
/// second one.
void Reach::meet(ProxyId own, ProxyId other, const Vec2& shift, StepList<ContactIndex>& added) {
    const ShiftedShapes pair = inOrder(own, other, shift);
    if (!mayPair(stores_.space[own], stores_.space[other]) || !mayTouch(stores_.bodies, stores_.space, pair) ||
        findContact(stores_.contacts, stores_.bodies, stores_.space, pair) != none)
        return;
    added.push_back(addEarlyContact(stores_.contacts, stores_.bodies, stores_.space, pair));
}

}  // namespace plumb
