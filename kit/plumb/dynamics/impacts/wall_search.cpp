// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/wall_search.h>

#include <algorithm>
#include <cmath>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/bodies/shape_radii.h>
#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

namespace {

/// A body may be this deep in a wall, as a share of its inradius [-], and at most this deep [m]: the solver pushes it
/// out.
constexpr double deepShare = 0.25;
constexpr double deepest = 0.02;
/// A body is stopped at this distance from the wall [m].
constexpr double skin = 1e-4;
/// Smaller distances make no difference; the search has about this tolerance [m].
constexpr double noticeable = 2e-5;
/// If a body moves through more periods of a wrapped world than this in one step, only the first ones are searched [-].
constexpr double mostPeriods = 64;

/// The time at which a shape has met a wall that it goes through, or too deep into; empty if it does neither.
std::optional<double> timeOfCrossing(const SweptShape& wall, const SweptShape& moving) {
    const double deep = std::min(deepShare * inradiusOf(*moving.shape), deepest);
    const double start =
        distance(*wall.shape, poseAt(wall.sweep, 0), *moving.shape, poseAt(moving.sweep, 0)).separation;
    // A body that is deeper already at the start, as under a heavy load, is stopped if it goes deeper.
    const std::optional<double> crossed = timeOfApproach(wall, moving, std::min(skin - deep, start - noticeable), 0);
    return crossed && start > skin ? timeOfApproach(wall, moving, skin, 0) : crossed;
}

/// The same for two shapes that are near each other only in a part of their sweeps: only that part is searched.
std::optional<double> timeOfCrossingIn(const RayPart& part, SweptShape wall, SweptShape moving) {
    if (part.first <= 0 && part.last >= 1) return timeOfCrossing(wall, moving);
    if (!(part.first <= part.last)) return std::nullopt;
    wall.sweep = partOf(wall.sweep, part.first, part.last);
    moving.sweep = partOf(moving.sweep, part.first, part.last);
    const std::optional<double> time = timeOfCrossing(wall, moving);
    return time ? std::optional(part.first + (part.last - part.first) * *time) : std::nullopt;
}

/// A body's motion relative to a wall.
struct Passage {
    Vec2 from{0, 0}, to{0, 0};  ///< places of the body's centre, in the wall's frame [m]
    double bend = 0;            ///< upper bound on its path's distance from the straight line between them [m]
    double turn = 0;            ///< relative rotation [rad]

    /// An upper bound on how far a point of the body's outline has moved [m].
    double travel(const BodyRecord& body) const {
        return (to - from).norm() + bend + std::fabs(turn) * body.turningRadius;
    }
};

Passage passageOf(const WallSweep& wall, const Sweep& way) {
    const Vec2 before = way.start - wall.sweep.start;
    const Vec2 after = before + (way.shift - wall.sweep.shift);
    const double spin = std::fabs(wall.sweep.turn);
    const double bend = spin * (2 * (after - before).norm() + spin * std::max(before.norm(), after.norm())) / 8;
    const Vec2& center = wall.sweep.localCenter;
    return {wall.toWallBefore * before + center, wall.toWallAfter * after + center, bend, way.turn - wall.sweep.turn};
}

}  // namespace

bool mayCross(const WallSweep& wall, const Sweep& way, const Shape& face, const BodyRecord& body) {
    const Passage passage = passageOf(wall, way);
    if (!isFar(body, passage.travel(body))) return false;
    const Aabb line{passage.from.cwiseMin(passage.to), passage.from.cwiseMax(passage.to)};
    return overlap(inflate(line, body.boundingRadius + passage.bend), aabbOf(face, {}));
}

void WallSearch::searchContact(ContactIndex index) {
    const ContactRecord& contact = view_.contacts[index];
    const bool isA = contact.bodyA == body_;
    if (isA)
        meet(contact.proxyA, contact.proxyB, contact.shift);
    else
        meet(contact.proxyB, contact.proxyA, -contact.shift);
}

void WallSearch::searchStatic() {
    if (view_.bodies.wrap.isExceededBy(sweep_.shift))
        return meetAlongPeriods([](const Proxy& other) { return other.fixed; });
    meetNear([](const Space& space, const Aabb& box, Space::Visit visit) { space.queryFixed(box, visit); });
}

void WallSearch::searchKinematic() {
    if (view_.bodies.kinematic.empty()) return;
    if (view_.bodies.wrap.isExceededBy(sweep_.shift))
        return meetAlongPeriods([](const Proxy& other) { return !other.fixed; });
    meetNear([](const Space& space, const Aabb& box, Space::Visit visit) {
        space.query(box, [&](ProxyId other, const Vec2& shift) {
            if (!space[other].fixed) visit(other, shift);
        });
    });
}

bool WallSearch::isWithinBounds() const {
    const double turned = std::fabs(sweep_.turn) * view_.bodies.record[body_].turningRadius;
    const double spare = 0.5 * static_cast<double>(contactMargin);
    return excessOfPrediction(view_.bodies, body_, sweep_.shift, turned) < spare;
}

void WallSearch::meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part) {
    const bool ruled = hasRule(view_.space[own].def) || hasRule(view_.space[other].def);
    const Verdict verdict = ruled ? verdictOn(own, other, shift) : Verdict::Solid;
    if (letsPass(verdict)) return;
    const BodyIndex wall = view_.space[other].owner;
    Sweep wallSweep = freeSweep(view_.bodies, wall, past_);
    wallSweep.start += shift;
    const Shape& shape = view_.space[own].def.shape;
    const Shape& face = view_.space[other].def.shape;
    if (!mayCross(WallSweep(wallSweep), sweep_, face, view_.bodies.record[body_])) return;
    const SweptShape swept{&shape, sweep_, turningRadiusOf(shape, sweep_.localCenter)};
    const std::optional<double> time = timeOfCrossingIn(part, {&face, wallSweep, 0}, swept);
    if (!time || (first_ && *time >= first_->time)) return;
    if (verdict == Verdict::Solid || isSolidAt(*time, {&face, wallSweep, 0}, swept, own, other))
        first_ = WallHit{*time, wall, wallSweep, shift};
}

Verdict WallSearch::verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const {
    Verdict verdict = Verdict::Open;
    forEachContact(view_.bodies, view_.contacts, body_, [&](ContactIndex index) {
        const ContactRecord& contact = view_.contacts[index];
        if ((contact.proxyA == own && contact.proxyB == other && contact.shift == shift) ||
            (contact.proxyB == own && contact.proxyA == other && contact.shift == -shift))
            verdict = contact.verdict;
    });
    return verdict;
}

/// Evaluates the rules where a shape meets the wall, for a pair without a verdict.
bool WallSearch::isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own,
                           ProxyId other) const {
    const Distance met = distance(*wall.shape, poseAt(wall.sweep, time), *swept.shape, poseAt(swept.sweep, time));
    const double duration = std::max(past_.from - past_.to, 1e-9);
    const auto velocityOf = [&](const Sweep& way, const Vec2& point) {
        return Vec2((way.shift + perp(Vec2(point - way.start - way.shift * time)) * way.turn) / duration);
    };
    const Face face{met.normal, velocityOf(swept.sweep, met.pointB) - velocityOf(wall.sweep, met.pointA),
                    met.separation};
    const Proxy& a = view_.space[other];
    const Proxy& b = view_.space[own];
    return rulesAdmit(view_.bodies, a, b, face) && comesFromOpenSide(view_.bodies, a, b, face, false);
}

void WallSearch::meetNear(FunctionRef<void(const Space&, const Aabb&, Space::Visit)> query) {
    const Space& space = view_.space;
    const BodyRecord& record = view_.bodies.record[body_];
    const Vec2 end = sweep_.start + sweep_.shift;
    const Aabb box = inflate({sweep_.start.cwiseMin(end), sweep_.start.cwiseMax(end)}, record.boundingRadius);
    query(space, box, [&](ProxyId other, const Vec2& shift) { meetAll(other, shift); });
}

void WallSearch::meetAll(ProxyId other, const Vec2& shift, const RayPart& part) {
    const Space& space = view_.space;
    if (view_.bodies.isDynamic(space[other].owner) || space[other].def.sensor) return;
    for (const ProxyId own : view_.bodies.links[body_].proxies)
        if (!space[own].def.sensor && mayPair(space[own], space[other]) &&
            !view_.bodies.areKeptApart(body_, space[other].owner))
            meet(own, other, shift, part);
}

/// The part of the sweep in which the body may touch the bounds of another shape.
RayPart WallSearch::partNear(ProxyId other, const Vec2& shift) const {
    const double boundingRadius = view_.bodies.record[body_].boundingRadius;
    const Aabb box = inflate(view_.space.box(other), boundingRadius * (1 + 1e-6) + skin);
    return clipRay(sweep_.start, sweep_.start + sweep_.shift, {box.lower + shift, box.upper + shift});
}

/// The search for a sweep that is longer than a period of a world that wraps: shapes are checked in the order along the
/// path, through at most 64 periods.
void WallSearch::meetAlongPeriods(FunctionRef<bool(const Proxy&)> wanted) {
    const Wrap& wrap = view_.bodies.wrap;
    double part = 1;
    if (wrap.width) part = std::min(part, mostPeriods * *wrap.width / std::fabs(sweep_.shift.x()));
    if (wrap.height) part = std::min(part, mostPeriods * *wrap.height / std::fabs(sweep_.shift.y()));
    const double boundingRadius = view_.bodies.record[body_].boundingRadius;
    view_.space.castBox({boundingRadius, boundingRadius}, sweep_.start, sweep_.start + sweep_.shift * part,
                        [&](ProxyId other, const Vec2& shift) {
                            if (wanted(view_.space[other])) meetAll(other, shift, partNear(other, shift));
                            return first_ ? std::min(first_->time / part, 1.0) : 1.0;
                        });
}

}  // namespace plumb
