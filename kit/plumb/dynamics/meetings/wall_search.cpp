// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/wall_search.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/contacts/contact_rules.h>
#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// A body is stopped at this distance from the wall [m]: several times the tolerance of the search, so that it does not
/// begin its next move in overlap.
constexpr double skin = 1e-4;
/// A point of a face is there if it is this near to the wall [m]: a few times skin, at which the body was stopped.
constexpr float faceMargin = 3e-4f;
/// A slower approach is none [m/s].
constexpr double noApproach = 1e-6;
/// So few kinematic bodies are looked at one by one [-]: a query of the space, which has all shapes, would take longer.
constexpr std::size_t fewKinematic = 8;
/// Most depths at which a crossing is looked at [-]; each is a search for a time.
constexpr int mostDepths = 6;
/// Smaller distances make no difference; the search has about this tolerance [m].
constexpr double noticeable = 2e-5;
/// If a body moves through more periods of a wrapped world than this in one step, only the first ones are searched [-].
constexpr double mostPeriods = 64;

/// The times at which a shape that goes through a wall, or too deep into it, comes to certain depths: one after the
/// other, as long as it does. The first is where it touches, if it was apart; then where it is too deep, and deeper.
/// Several are needed, because a touch may be one that parts or slides along, which is not to be stopped, and the body
/// may then go in deeper: the depths reach down to where it would be at the end. A body that moved by less than its
/// inradius, and is not too deep, costs one distance.
class Crossing {
public:
    /// travel: how far the moving shape's outline moves relative to the wall, at most [m].
    Crossing(const RayPart& part, SweptShape wall, SweptShape moving, double travel)
        : part_(part), wall_(std::move(wall)), moving_(std::move(moving)) {
        if (part.first > 0 || part.last < 1) {  // the two are near each other only in this part of their sweeps
            wall_.sweep = partOf(wall_.sweep, part.first, part.last);
            moving_.sweep = partOf(moving_.sweep, part.first, part.last);
        }
        const double inradius = inradiusOf(*moving_.shape);
        deep_ = deepIn(inradius);
        // The largest disc in the shape cannot have come to the other side if it moved by less than its radius.
        if (travel <= inradius && separationAt(1) > skin - deep_) return;
        const double start = separationAt(0);
        // A body that is deeper already at the start, as under a heavy load, is stopped if it goes deeper.
        limit_ = std::min(skin - deep_, start - noticeable);
        deeper_ = limit_ - separationAt(1);
        crosses_ = timeOfApproach(wall_, moving_, limit_, 0);
        if (crosses_ && start > skin + noticeable) touches_ = timeOfApproach(wall_, moving_, skin, 0);
    }

    std::optional<double> next() {
        const int number = tried_++;
        if (number == 0 && touches_) return atPart(*touches_);
        if (number > (touches_ ? 1 : 0) && crosses_) {
            limit_ -= std::max(0.5 * deep_, deeper_ / mostDepths);
            crosses_ = timeOfApproach(wall_, moving_, limit_, *crosses_);
        }
        return crosses_ && number < mostDepths ? atPart(*crosses_) : std::nullopt;
    }

private:
    double separationAt(double time) const {
        return distance(*wall_.shape, poseAt(wall_.sweep, time), *moving_.shape, poseAt(moving_.sweep, time))
            .separation;
    }
    std::optional<double> atPart(double time) const { return part_.first + (part_.last - part_.first) * time; }

    RayPart part_;
    SweptShape wall_, moving_;
    double deep_ = 0, limit_ = 0;
    double deeper_ = 0;  ///< by how much it goes beyond the first limit [m]
    std::optional<double> touches_, crosses_;
    int tried_ = 0;
};

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

/// The body's motion in the frame of a wall that moves and turns. A path is off its chord by at most T^2 / 8 times the
/// largest second derivative; in a turning frame that is 2 spin v (Coriolis) and spin^2 r (centripetal), so
/// bend = spin (2 |shift| + spin r) / 8
/// spin turn of the wall in the sweep [rad], shift of the body relative to the wall, r its larger distance from the
/// wall's centre at both ends [m]
Passage passageOf(const WallSweep& wall, const Sweep& sweep) {
    const Vec2 before = sweep.start - wall.sweep.start;
    const Vec2 after = before + (sweep.shift - wall.sweep.shift);
    const double spin = std::fabs(wall.sweep.turn);
    const double bend = spin * (2 * (after - before).norm() + spin * std::max(before.norm(), after.norm())) / 8;
    const Vec2& center = wall.sweep.localCenter;
    return {wall.toWallBefore * before + center, wall.toWallAfter * after + center, bend, sweep.turn - wall.sweep.turn};
}

}  // namespace

BodyMotion motionAt(const Sweep& sweep, double time, double duration) {
    BodyMotion motion;
    motion.center = sweep.start + sweep.shift * time;
    motion.angle = sweep.angle + sweep.turn * time;
    motion.rotation = Rot::fromAngle(motion.angle);
    motion.velocity = sweep.shift / duration;
    motion.angularVelocity = sweep.turn / duration;
    return motion;
}

double travelTowards(const WallSweep& wall, const Sweep& sweep, const Shape& face, const BodyRecord& body) {
    const Passage passage = passageOf(wall, sweep);
    const Aabb line{passage.from.cwiseMin(passage.to), passage.from.cwiseMax(passage.to)};
    const bool near = overlap(inflate(line, body.boundingRadius + passage.bend), aabbOf(face, {}));
    return near ? passage.travel(body) : 0;
}

/// In a world that wraps, only the space knows the images that are near.
void forEachKinematicNear(const WallView& view, const Aabb& box, Space::Visit visit) {
    const BodyStore& bodies = view.bodies;
    if (bodies.kinematic.size() <= fewKinematic && !bodies.wrap.any()) {
        for (const BodyIndex wall : bodies.kinematic)
            for (const ProxyId other : bodies.links[wall].proxies)
                if (bodies.record[wall].enabled && overlap(box, view.space.box(other))) visit(other, Vec2(0, 0));
        return;
    }
    view.space.query(box, [&](ProxyId other, const Vec2& shift) {
        if (bodies.record[view.space[other].owner].type == BodyType::Kinematic) visit(other, shift);
    });
}

/// One query of the box around the path; of walls that are met, the first one counts. The space keeps fixed shapes
/// apart, so a crowd of loose bodies costs nothing here.
void WallSearch::searchStatic() {
    if (view_.bodies.wrap.isExceededBy(sweep_.shift))
        return meetAlongPeriods([](const Proxy& other) { return other.fixed; });
    meetNear([this](const Aabb& box, Space::Visit visit) { view_.space.queryFixed(box, visit); });
}

void WallSearch::searchKinematic() {
    if (view_.bodies.kinematic.empty()) return;
    if (view_.bodies.wrap.isExceededBy(sweep_.shift))
        return meetAlongPeriods([](const Proxy& other) { return !other.fixed; });
    meetNear([this](const Aabb& box, Space::Visit visit) { forEachKinematicNear(view_, box, visit); });
}

/// The tests in the order of their cost: rules that let pass; the bounds of travel; the search for the time. A time
/// that is not before the first one so far ends the search: later depths come even later.
void WallSearch::meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part) {
    const bool ruled = hasRule(view_.space[own].def) || hasRule(view_.space[other].def);
    const Verdict verdict = ruled ? verdictOn(own, other, shift) : Verdict::Solid;
    if (letsPass(verdict)) return;
    Sweep wallSweep = wallSweepOf(view_.bodies, view_.space[other].owner, part_);
    wallSweep.start += shift;
    const Shape& shape = view_.space[own].def.shape;
    const Shape& face = view_.space[other].def.shape;
    const double travel = travelTowards(WallSweep(wallSweep), sweep_, face, view_.bodies.record[body_]);
    if (travel <= far_) return;
    const SweptShape swept{&shape, sweep_, turningRadiusOf(shape, sweep_.localCenter)};
    if (!(part.first <= part.last)) return;
    Crossing crossing(part, {&face, wallSweep, 0}, swept, travel);
    while (const std::optional<double> time = crossing.next()) {
        if (first_ && *time >= first_->time) return;
        const WallHit hit{*time, own, other, wallSweep, shift, manifoldAt(*time, wallSweep, own, other)};
        if (!approaches(hit) && !isLost(hit)) continue;
        if (verdict != Verdict::Solid && !isSolidAt(*time, {&face, wallSweep, 0}, swept, own, other)) return;
        first_ = hit;
        return;
    }
}

/// A contact of the pair has the verdict of this touch already, which must not change while the shape passes.
Verdict WallSearch::verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const {
    const ContactIndex contact = findContact(view_.contacts, view_.bodies, view_.space, {{own, other}, shift});
    return contact == none ? Verdict::Open : view_.contacts[contact].verdict;
}

/// Empty at a corner that the rest of a chain covers: another of its segments is met there.
Manifold WallSearch::manifoldAt(double time, const Sweep& wallSweep, ProxyId own, ProxyId other) const {
    const BodyMotion body = motionAt(sweep_, time, 1), wall = motionAt(wallSweep, time, 1);
    const ProxyId a = std::min(own, other), b = std::max(own, other);
    return manifold(view_.space[a].convex, view_.space[b].convex,
                    a == own ? relativePose(body, wall) : relativePose(wall, body), faceMargin);
}

/// Has the search for the time come to an end before the two met, because the body spins too fast?
bool WallSearch::isLost(const WallHit& hit) const {
    if (hit.manifold.count > 0) return false;
    const Distance apart = distance(view_.space[hit.wall].def.shape, poseAt(hit.wallSweep, hit.time),
                                    view_.space[hit.own].def.shape, poseAt(sweep_, hit.time));
    return apart.separation > static_cast<double>(faceMargin);
}

/// Does a point of the manifold approach the wall? At a touch that parts, or slides along, nothing is to be stopped.
bool WallSearch::approaches(const WallHit& hit) const {
    const double duration = std::max(part_.to - part_.from, 1e-9);
    const BodyMotion body = motionAt(sweep_, hit.time, duration), wall = motionAt(hit.wallSweep, hit.time, duration);
    const BodyMotion &a = hit.own < hit.wall ? body : wall, &b = hit.own < hit.wall ? wall : body;
    const Vec2 normal = a.rotation * Vec2(hit.manifold.normal.cast<double>());
    for (int p = 0; p < hit.manifold.count; ++p) {
        const Vec2 local = hit.manifold.points[static_cast<std::size_t>(p)].position.cast<double>();
        const Vec2 at = a.center + a.rotation * local;
        if (Vec2(velocityAt(a, at) - velocityAt(b, at)).dot(normal) > noApproach) return true;
    }
    return false;
}

/// Evaluates the rules where a shape meets the wall, for a pair without a verdict: which face is met, and how fast, is
/// known only there.
bool WallSearch::isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own,
                           ProxyId other) const {
    const Distance met = distance(*wall.shape, poseAt(wall.sweep, time), *swept.shape, poseAt(swept.sweep, time));
    const double duration = std::max(part_.to - part_.from, 1e-9);
    const auto velocityOf = [&](const Sweep& sweep, const Vec2& point) {
        return Vec2((sweep.shift + perp(Vec2(point - sweep.start - sweep.shift * time)) * sweep.turn) / duration);
    };
    const Face face{met.normal, velocityOf(swept.sweep, met.pointB) - velocityOf(wall.sweep, met.pointA),
                    met.separation};
    const Proxy& a = view_.space[other];
    const Proxy& b = view_.space[own];
    return rulesAdmit(view_.bodies, a, b, face) && comesFromOpenSide(view_.bodies, a, b, face, false);
}

void WallSearch::meetNear(FunctionRef<void(const Aabb&, Space::Visit)> query) {
    const BodyRecord& record = view_.bodies.record[body_];
    const Vec2 end = sweep_.start + sweep_.shift;
    const Aabb box = inflate({sweep_.start.cwiseMin(end), sweep_.start.cwiseMax(end)}, record.boundingRadius);
    query(box, [&](ProxyId other, const Vec2& shift) { meetAll(other, shift); });
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
/// path, through at most 64 periods. A box around such a path would hold every image of every shape. Test: "a body is
/// stopped by a wall that it meets in its 63rd round in a sub-step, and not in its 66th"
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
