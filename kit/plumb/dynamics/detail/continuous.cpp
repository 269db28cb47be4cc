// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/continuous.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/detail/contact_rules.h>
#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/fresh_lanes.h>
#include <plumb/dynamics/detail/pairs.h>
#include <plumb/dynamics/detail/shape_measure.h>

namespace plumb {

namespace {

/// A body that moves by less than this share of its core in a step is still where its contacts see it [-].
constexpr double slow = 0.5;
/// This share of its core, and no more than this [m], a body may be deep in a wall: the solver pushes it out.
constexpr double deepShare = 0.25;
constexpr double deepest = 0.02;
/// A body is stopped this far from the wall [m].
constexpr double skin = 1e-4;
/// Less than this makes no difference, and a search ends as near as that [m].
constexpr double noticeable = 2e-5;

Way wayBetween(const BodyMotion& from, const BodyMotion& to, const BodyRecord& record) {
    return {from.center, to.center - from.center, from.angle, to.angle - from.angle, record.localCenter};
}

/// A part of the step, counted back from its end [s].
struct Past {
    double from = 0, to = 0;
};

/// How a body that the solver has not moved has come through a part of the step.
Way freeWay(const WorldState& world, BodyIndex body, const Past& past) {
    const BodyRecord& record = world.bodies.record[body];
    BodyMotion now = world.bodies.motion[body];
    if (!record.awake) return wayBetween(now, now, record);
    const FlightLaw law = flightLawOf(world, body);
    if (record.flight != none) {  // without what was added at its end
        now.velocity -= world.fields.flights[record.flight].rest.velocity;
        now.angularVelocity -= world.fields.flights[record.flight].rest.spin;
    }
    return wayBetween(fly(now, law, -past.from), past.to > 0 ? fly(now, law, -past.to) : now, record);
}

/// What the solver has moved a body by.
struct Moved {
    Vec2 shift{0, 0};
    double turn = 0;
};

Moved movedBy(const WorldState& world, BodyIndex body) {
    const SolverDisplacement& moved = world.bodies.displacement[body];
    return {Vec2(static_cast<double>(moved.x), static_cast<double>(moved.y)),
            static_cast<double>(world.bodies.turn[body].angle)};
}

/// How a body has come through this step.
Way wayOf(const WorldState& world, BodyIndex body, double dt) {
    if (world.bodies.pushed[body] == 0) return freeWay(world, body, {dt, 0});
    const BodyMotion& now = world.bodies.motion[body];
    const Moved moved = movedBy(world, body);
    return {now.center - moved.shift, moved.shift, now.angle - moved.turn, moved.turn,
            world.bodies.record[body].localCenter};
}

/// No point of the body's outline has moved farther than this [m].
double travelOf(const Vec2& shift, double turn, const BodyRecord& record) {
    return shift.norm() + std::fabs(turn) * record.reach;
}

/// When a shape that goes through a wall, or too deep into it, has met it; empty when it does neither.
std::optional<double> timeOfCrossing(const SweptShape& wall, const SweptShape& moving) {
    const double deep = std::min(deepShare * coreOf(*moving.shape), deepest);
    const double start = distance(*wall.shape, poseOn(wall.way, 0), *moving.shape, poseOn(moving.way, 0)).separation;
    // What is deeper already, as under a heavy load, goes no deeper.
    const std::optional<double> crossed = timeWithin(wall, moving, std::min(skin - deep, start - noticeable), 0);
    return crossed && start > skin ? timeWithin(wall, moving, skin, 0) : crossed;
}

Way partOf(const Way& way, const RayPart& part) {
    const double share = part.last - part.first;
    return {way.start + way.shift * part.first, way.shift * share, way.angle + way.turn * part.first, way.turn * share,
            way.localCenter};
}

/// The same of two that are far from each other outside of a part of their ways: the search is as long as that.
std::optional<double> timeOfCrossingIn(const RayPart& part, SweptShape wall, SweptShape moving) {
    if (part.first <= 0 && part.last >= 1) return timeOfCrossing(wall, moving);
    if (!(part.first <= part.last)) return std::nullopt;
    wall.way = partOf(wall.way, part);
    moving.way = partOf(moving.way, part);
    const std::optional<double> time = timeOfCrossing(wall, moving);
    return time ? std::optional(part.first + (part.last - part.first) * *time) : std::nullopt;
}

struct Hit {
    double time = 0;
    BodyIndex wall = noBody;
    Way wallWay;
    Vec2 shift{0, 0};  ///< of the wall, in a world that wraps [m]
};

/// Where a body stays that meets a wall on its way: there, or, if the wall moves on, at the same place of it.
Way stayAt(const WorldState& world, const Way& way, const Hit& hit) {
    Way stay = way;
    stay.start = way.start + way.shift * hit.time;
    stay.angle = way.angle + way.turn * hit.time;
    const BodyMotion& wall = world.bodies.motion[hit.wall];
    const Vec2 wallThen = hit.wallWay.start + hit.wallWay.shift * hit.time;
    stay.turn = wall.angle - (hit.wallWay.angle + hit.wallWay.turn * hit.time);
    stay.shift = (wall.center + hit.shift - stay.start) + Rot::fromAngle(stay.turn) * Vec2(stay.start - wallThen);
    return stay;
}

/// A body's way as seen from a wall.
struct Passage {
    Vec2 from{0, 0}, to{0, 0};  ///< of its centre, in the wall's frame [m]
    double bend = 0;            ///< no farther than this off the straight line between the two [m]
    double turn = 0;            ///< [rad]

    /// No point of the body's outline has moved farther than this [m].
    double travel(const BodyRecord& body) const { return (to - from).norm() + bend + std::fabs(turn) * body.reach; }
};

/// A wall's way, and how it is turned at both ends.
struct WallWay {
    Way way;
    Rot toWallBefore, toWallAfter;

    explicit WallWay(const Way& w)
        : way(w),
          toWallBefore(Rot::fromAngle(w.angle).inverse()),
          toWallAfter(w.turn == 0 ? toWallBefore : Rot::fromAngle(w.angle + w.turn).inverse()) {}
};

Passage passageOf(const WallWay& wall, const Way& way) {
    const Vec2 before = way.start - wall.way.start;
    const Vec2 after = before + (way.shift - wall.way.shift);
    const double spin = std::fabs(wall.way.turn);
    const double bend = spin * (2 * (after - before).norm() + spin * std::max(before.norm(), after.norm())) / 8;
    const Vec2& center = wall.way.localCenter;
    return {wall.toWallBefore * before + center, wall.toWallAfter * after + center, bend, way.turn - wall.way.turn};
}

/// Is this so far for a body of its size that it may have gone through something?
bool isFar(const BodyRecord& record, double travel) {
    return travel > slow * record.core;
}

/// May a body on this way have gone through a shape of a wall?
bool mayCross(const Passage& passage, const Shape& face, const BodyRecord& body) {
    if (!isFar(body, passage.travel(body))) return false;
    const Aabb line{passage.from.cwiseMin(passage.to), passage.from.cwiseMax(passage.to)};
    return overlap(inflate(line, body.extent + passage.bend), aabbOf(face, {}));
}

/// Looks for the first wall that a body crosses on its way through a part of the step.
class Search {
public:
    Search(const WorldState& world, BodyIndex body, const Way& way, const Past& past)
        : world_(world), body_(body), way_(way), past_(past) {}

    const std::optional<Hit>& first() const { return first_; }

    /// shift: of the other; part: of the way, outside of which the two are far from each other.
    void meet(ProxyId own, ProxyId other, const Vec2& shift, const RayPart& part = {}) {
        const bool ruled = hasRule(world_.space[own].def) || hasRule(world_.space[other].def);
        const Verdict verdict = ruled ? verdictOn(own, other, shift) : Verdict::Solid;
        if (letsPass(verdict)) return;
        const BodyIndex wall = world_.space[other].owner;
        Way wallWay = freeWay(world_, wall, past_);
        wallWay.start += shift;
        const Shape& shape = world_.space[own].def.shape;
        const Shape& face = world_.space[other].def.shape;
        if (!mayCross(passageOf(WallWay(wallWay), way_), face, world_.bodies.record[body_])) return;
        const SweptShape swept{&shape, way_, reachOf(shape, way_.localCenter)};
        const std::optional<double> time = timeOfCrossingIn(part, {&face, wallWay, 0}, swept);
        if (!time || (first_ && *time >= first_->time)) return;
        if (verdict == Verdict::Solid || isSolidAt(*time, {&face, wallWay, 0}, swept, own, other))
            first_ = Hit{*time, wall, wallWay, shift};
    }

    void meet(ContactIndex index) {
        const ContactRecord& contact = world_.contacts.contacts[index];
        const bool isA = contact.bodyA == body_;
        if (isA)
            meet(contact.proxyA, contact.proxyB, contact.shift);
        else
            meet(contact.proxyB, contact.proxyA, -contact.shift);
    }

    void meetFixed() {
        if (goesRound()) return meetAround([](const Proxy& other) { return other.fixed; });
        meetNear([](const Space& space, const Aabb& box, Space::Visit visit) { space.queryFixed(box, visit); });
    }

    void meetKinematic() {
        if (world_.bodies.kinematic.empty()) return;
        if (goesRound()) return meetAround([](const Proxy& other) { return !other.fixed; });
        meetNear([](const Space& space, const Aabb& box, Space::Visit visit) {
            space.query(box, [&](ProxyId other, const Vec2& shift) {
                if (!space[other].fixed) visit(other, shift);
            });
        });
    }

    /// In the boxes for which its contacts were made? Not if it was pushed or deflected within the step.
    bool keptToBoxes() const {
        const BodyPlace& place = world_.bodies.place[body_];
        const auto excess = [](double moved, double foreseen) {
            return std::max(std::min(foreseen, 0.0) - moved, moved - std::max(foreseen, 0.0));
        };
        const Vec2 foreseen = foreseenShift(world_, body_);
        const double aside =
            std::max({excess(way_.shift.x(), foreseen.x()), excess(way_.shift.y(), foreseen.y()), 0.0});
        const double turned = std::fabs(way_.turn) * world_.bodies.record[body_].reach;
        return aside + std::max(turned - static_cast<double>(place.turn), 0.0) <
               0.5 * static_cast<double>(contactMargin);
    }

private:
    Verdict verdictOn(ProxyId own, ProxyId other, const Vec2& shift) const {
        Verdict verdict = Verdict::Open;
        forEachContact(world_.bodies, world_.contacts, body_, [&](ContactIndex index) {
            const ContactRecord& contact = world_.contacts.contacts[index];
            if ((contact.proxyA == own && contact.proxyB == other && contact.shift == shift) ||
                (contact.proxyB == own && contact.proxyA == other && contact.shift == -shift))
                verdict = contact.verdict;
        });
        return verdict;
    }

    /// Asks the rules of what was not seen coming, where it meets the wall.
    bool isSolidAt(double time, const SweptShape& wall, const SweptShape& swept, ProxyId own, ProxyId other) const {
        const Distance met = distance(*wall.shape, poseOn(wall.way, time), *swept.shape, poseOn(swept.way, time));
        const double duration = std::max(past_.from - past_.to, 1e-9);
        const auto velocityOf = [&](const Way& way, const Vec2& point) {
            return Vec2((way.shift + perp(Vec2(point - way.start - way.shift * time)) * way.turn) / duration);
        };
        const Face face{met.normal, velocityOf(swept.way, met.pointB) - velocityOf(wall.way, met.pointA),
                        met.separation};
        const Proxy& a = world_.space[other];
        const Proxy& b = world_.space[own];
        return rulesAdmit(world_, a, b, face) && comesFromOpenSide(world_, a, b, face, false);
    }

    void meetNear(FunctionRef<void(const Space&, const Aabb&, Space::Visit)> query) {
        const Space& space = world_.space;
        const BodyRecord& record = world_.bodies.record[body_];
        const Vec2 end = way_.start + way_.shift;
        const Aabb box = inflate({way_.start.cwiseMin(end), way_.start.cwiseMax(end)}, record.extent);
        query(space, box, [&](ProxyId other, const Vec2& shift) { meetAll(other, shift); });
    }

    void meetAll(ProxyId other, const Vec2& shift, const RayPart& part = {}) {
        const Space& space = world_.space;
        if (world_.bodies.isDynamic(space[other].owner) || space[other].def.sensor) return;
        for (const ProxyId own : world_.bodies.record[body_].proxies)
            if (!space[own].def.sensor && mayPair(space[own], space[other]) &&
                !joinedApart(world_, body_, space[other].owner))
                meet(own, other, shift, part);
    }

    /// The part of the way on which the body may touch a shape's box.
    RayPart partNear(ProxyId other, const Vec2& shift) const {
        const double extent = world_.bodies.record[body_].extent;
        const Aabb box = inflate(world_.space.box(other), extent * (1 + 1e-6) + skin);
        return clipRay(way_.start, way_.start + way_.shift, {box.lower + shift, box.upper + shift});
    }

    /// Is the way longer than a world that wraps?
    bool goesRound() const {
        const Wrap& wrap = world_.def.wrap;
        return (wrap.width && std::fabs(way_.shift.x()) > *wrap.width) ||
               (wrap.height && std::fabs(way_.shift.y()) > *wrap.height);
    }

    /// Then what lies on the way is met in its order, and, of more than 64 rounds, on the first 64.
    void meetAround(FunctionRef<bool(const Proxy&)> wanted) {
        constexpr double mostRounds = 64;
        const Wrap& wrap = world_.def.wrap;
        double part = 1;
        if (wrap.width) part = std::min(part, mostRounds * *wrap.width / std::fabs(way_.shift.x()));
        if (wrap.height) part = std::min(part, mostRounds * *wrap.height / std::fabs(way_.shift.y()));
        const double extent = world_.bodies.record[body_].extent;
        world_.space.castBox({extent, extent}, way_.start, way_.start + way_.shift * part,
                             [&](ProxyId other, const Vec2& shift) {
                                 if (wanted(world_.space[other])) meetAll(other, shift, partNear(other, shift));
                                 return first_ ? std::min(first_->time / part, 1.0) : 1.0;
                             });
    }

    const WorldState& world_;
    BodyIndex body_;
    const Way& way_;
    Past past_;
    std::optional<Hit> first_;
};

/// Puts the body to where it met the wall. What moves on carries it along, perhaps into what does not.
void stopAt(WorldState& world, BodyIndex body, const Way& way, const Past& past, const Hit& hit) {
    Way stopped = stayAt(world, way, hit);
    if (world.bodies.record[hit.wall].type == BodyType::Kinematic) {
        const Way carried = stopped;
        Search search(world, body, carried, past);
        search.meetFixed();
        if (search.first()) stopped = stayAt(world, carried, *search.first());
    }
    BodyMotion motion = world.bodies.motion[body];
    motion.center = stopped.start + stopped.shift;
    motion.angle = stopped.angle + stopped.turn;
    motion.rotation = Rot::fromAngle(motion.angle);
    moveTo(world, body, motion);
}

/// Asked of all that moves, so that nothing is looked up that need not be.
bool hasComeFar(const WorldState& world, BodyIndex body, double dt) {
    const BodyRecord& record = world.bodies.record[body];
    if (world.bodies.pushed[body] != 0) {
        const Moved moved = movedBy(world, body);
        return isFar(record, travelOf(moved.shift, moved.turn, record));
    }
    const Way way = freeWay(world, body, {dt, 0});
    return isFar(record, travelOf(way.shift, way.turn, record));
}

/// A dynamic body that was moved by the solver or by nothing.
bool isMoved(const BodyRecord& record) {
    return record.type == BodyType::Dynamic && record.awake && !record.flown && !record.quarantined;
}

/// A body that may have gone through a wall: through what it has this contact with, or, without, anything fixed.
struct Suspect {
    BodyIndex body = noBody;
    ContactIndex contact = none;
};

/// Bodies that have come far as seen from something kinematic, and near it.
void addSwept(const WorldState& world, BodyIndex wall, double dt, std::vector<Suspect>& suspects) {
    const WallWay wallWay(freeWay(world, wall, {dt, 0}));
    forEachContact(world.bodies, world.contacts, wall, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const bool isA = contact.bodyA == wall;
        const BodyIndex body = isA ? contact.bodyB : contact.bodyA;
        const BodyRecord& record = world.bodies.record[body];
        if (!isMoved(record)) return;
        const Shape& face = world.space[isA ? contact.proxyA : contact.proxyB].def.shape;
        Way own = wayOf(world, body, dt);
        own.start += isA ? contact.shift : Vec2(-contact.shift);
        const Passage passage = passageOf(wallWay, own);
        if (mayCross(passage, face, record)) suspects.push_back({body, index});
    });
}

/// In the order of their slots, those that have moved far for their size, or past which a wall has.
std::vector<Suspect> findSuspects(const WorldState& world, double dt) {
    std::vector<Suspect> suspects;
    for (const BodyIndex body : world.bodies.awake)
        if (isMoved(world.bodies.record[body]) && hasComeFar(world, body, dt)) suspects.push_back({body, none});
    for (const BodyIndex wall : world.bodies.kinematic) addSwept(world, wall, dt, suspects);
    std::sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) {
        return a.body != b.body ? a.body < b.body : a.contact < b.contact;
    });
    return suspects;
}

/// All of one body.
void stop(WorldState& world, std::span<const Suspect> suspects, double dt) {
    const BodyIndex body = suspects.front().body;
    const Way way = wayOf(world, body, dt);
    Search search(world, body, way, {dt, 0});
    for (const Suspect& suspect : suspects) {
        if (suspect.contact != none) {
            search.meet(suspect.contact);
            continue;
        }
        search.meetFixed();
        // The boxes for which contacts were made hold all else; what is kinematic is looked at from its side.
        if (!search.keptToBoxes()) search.meetKinematic();
    }
    if (search.first()) stopAt(world, body, way, {dt, 0}, *search.first());
}

/// Leg after leg, and a body that was stopped in one has none after it.
void stopFlights(WorldState& world, double dt) {
    std::vector<BodyIndex> stopped;
    for (const Leg& leg : world.legs) {
        const BodyRecord& record = world.bodies.record[leg.body];
        const Way way = wayBetween(leg.from, leg.to, record);
        if (!isFar(record, travelOf(way.shift, way.turn, record))) continue;
        if (std::find(stopped.begin(), stopped.end(), leg.body) != stopped.end()) continue;
        const Past past{dt - leg.start, dt - leg.end};
        Search search(world, leg.body, way, past);
        search.meetFixed();
        search.meetKinematic();
        if (!search.first()) continue;
        stopAt(world, leg.body, way, past, *search.first());
        stopped.push_back(leg.body);
    }
}

}  // namespace

void stopAtWalls(WorldState& world, double dt) {
    if (world.walls == 0) return;
    const std::vector<Suspect> suspects = findSuspects(world, dt);
    for (auto first = suspects.begin(); first != suspects.end();) {
        const auto last = std::find_if(first, suspects.end(), [&](const Suspect& s) { return s.body != first->body; });
        stop(world, {first, last}, dt);
        first = last;
    }
    stopFlights(world, dt);
}

}  // namespace plumb
