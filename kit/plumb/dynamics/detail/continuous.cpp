// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/continuous.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/detail/free_motion.h>
#include <plumb/dynamics/detail/sweep.h>

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
/// What a kinematic body must move for bodies that hardly move to be looked at for its sake [m].
constexpr double sweeping = 1e-3;

double coreOfOutline(const Circle& circle) {
    return circle.radius;
}

double coreOfOutline(const Capsule& capsule) {
    return capsule.radius;
}

double coreOfOutline(const Segment&) {
    return 0;
}

double coreOfOutline(const Chain&) {
    return 0;
}

/// Of the disc around the mean of the corners.
double coreOfOutline(const Polygon& polygon) {
    Vec2 middle(0, 0);
    for (const Vec2& v : polygon.vertices) middle += v / static_cast<double>(polygon.vertices.size());
    double core = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec2 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - polygon.vertices[i];
        core = std::min(core, cross(edge, Vec2(middle - polygon.vertices[i])) / edge.norm());
    }
    return core + polygon.radius;
}

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
    const BodyMotion& now = world.bodies.motion[body];
    if (!record.awake) return wayBetween(now, now, record);
    const FlightLaw law = flightLawOf(record, world.def.gravity);
    return wayBetween(fly(now, law, -past.from), past.to > 0 ? fly(now, law, -past.to) : now, record);
}

/// How a body has come through this step.
Way wayOf(const WorldState& world, BodyIndex body, double dt) {
    const BodyRecord& record = world.bodies.record[body];
    if (!record.pushed) return freeWay(world, body, {dt, 0});
    const BodyMotion& now = world.bodies.motion[body];
    const SolverDisplacement& moved = world.bodies.displacement[body];
    const Vec2 shift(static_cast<double>(moved.x), static_cast<double>(moved.y));
    const double turn = static_cast<double>(world.bodies.turn[body].angle);
    return {now.center - shift, shift, now.angle - turn, turn, record.localCenter};
}

/// No point of the body has moved farther than this [m].
double travelOf(const Way& way, const BodyRecord& record) {
    return way.shift.norm() + std::fabs(way.turn) * record.extent;
}

/// Farthest point that turning moves along a normal: of what is rounded, of the core within [m].
double reachOf(const Shape& shape, const Vec2& center) {
    double reach = 0;
    const auto take = [&](const Vec2& point) { reach = std::max(reach, (point - center).norm()); };
    if (const auto* circle = std::get_if<Circle>(&shape)) take(circle->center);
    if (const auto* polygon = std::get_if<Polygon>(&shape))
        for (const Vec2& corner : polygon->vertices) take(corner);
    const auto takeEnds = [&](const auto* line) {
        if (line == nullptr) return;
        take(line->start);
        take(line->end);
    };
    takeEnds(std::get_if<Capsule>(&shape));
    takeEnds(std::get_if<Segment>(&shape));
    return reach;
}

/// When a shape that goes through a wall, or too deep into it, has met it; empty when it does neither.
std::optional<double> timeOfCrossing(const SweptShape& wall, const SweptShape& moving) {
    const double deep = std::min(deepShare * coreOf(*moving.shape), deepest);
    const double start = distance(*wall.shape, poseOn(wall.way, 0), *moving.shape, poseOn(moving.way, 0)).separation;
    // What is deeper already, as under a heavy load, goes no deeper.
    const std::optional<double> crossed = timeWithin(wall, moving, std::min(skin - deep, start - noticeable), 0);
    return crossed && start > skin ? timeWithin(wall, moving, skin, 0) : crossed;
}

struct Hit {
    double time = 0;
    BodyIndex wall = noBody;
    Way wallWay;
};

/// A box around all that a shape passes through; as its corners swing out between both ends, by so much larger.
Aabb sweptBox(const Shape& shape, const Way& way) {
    const Aabb ends = merge(aabbOf(shape, poseOn(way, 0)), aabbOf(shape, poseOn(way, 1)));
    return inflate(ends, std::min(std::fabs(way.turn), 2.0) * reachOf(shape, way.localCenter));
}

/// Where a body stays that meets a wall on its way: there, or, if the wall moves on, at the same place of it.
Way stayAt(const WorldState& world, const Way& way, const Hit& hit) {
    Way stay = way;
    stay.start = way.start + way.shift * hit.time;
    stay.angle = way.angle + way.turn * hit.time;
    const BodyMotion& wall = world.bodies.motion[hit.wall];
    const Vec2 wallThen = hit.wallWay.start + hit.wallWay.shift * hit.time;
    stay.turn = wall.angle - (hit.wallWay.angle + hit.wallWay.turn * hit.time);
    stay.shift = (wall.center - stay.start) + Rot::fromAngle(stay.turn) * Vec2(stay.start - wallThen);
    return stay;
}

bool isWall(const WorldState& world, BodyIndex body, bool onlyFixed) {
    const BodyType type = world.bodies.record[body].type;
    return type == BodyType::Static || (type == BodyType::Kinematic && !onlyFixed);
}

[[maybe_unused]] bool joinedApart(const WorldState& world, BodyIndex a, BodyIndex b) {
    const auto& joints = world.bodies.record[a].joints;
    return std::any_of(joints.begin(), joints.end(), [&](std::uint32_t j) {
        const JointRecord& joint = world.joints[j];
        return !joint.collideConnected && (joint.bodyA == b || joint.bodyB == b);
    });
}

/// Has a body kept to the boxes for which its contacts were made? Not if it was pushed or deflected within the step.
bool keptToBoxes(const WorldState& world, BodyIndex body, const Way& way) {
    const auto& proxies = world.bodies.record[body].proxies;
    return std::all_of(proxies.begin(), proxies.end(), [&](ProxyId proxy) {
        return contains(world.space.box(proxy), sweptBox(world.space[proxy].def.shape, way));
    });
}

/// Calls visit(own, other) for each shape of a body and each that it may meet on its way.
template <class SomeSpace, class Visit>
void forEachNear(const WorldState& world, const SomeSpace& space, BodyIndex body, const Way& way, Visit&& visit) {
    if constexpr (requires { space.query(Aabb{}, [](ProxyId) {}); }) {
        if (!keptToBoxes(world, body, way)) {
            for (const ProxyId own : world.bodies.record[body].proxies) {
                space.query(sweptBox(space[own].def.shape, way), [&](ProxyId other) {
                    if (mayPair(space[own], space[other]) && !joinedApart(world, body, space[other].owner))
                        visit(own, other);
                });
            }
            return;
        }
    }
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const bool isA = contact.bodyA == body;
        visit(isA ? contact.proxyA : contact.proxyB, isA ? contact.proxyB : contact.proxyA);
    });
}

/// A body's way as seen from a wall.
struct Passage {
    Vec2 from{0, 0}, to{0, 0};  ///< of its centre, in the wall's frame [m]
    double bend = 0;            ///< no farther than this off the straight line between the two [m]
    double turn = 0;            ///< [rad]

    /// No point of the body has moved farther than this [m].
    double travel(const BodyRecord& body) const { return (to - from).norm() + bend + std::fabs(turn) * body.extent; }
};

Passage passageOf(const Way& wall, const Way& way) {
    const Vec2 before = way.start - wall.start;
    const Vec2 after = before + (way.shift - wall.shift);
    const Rot toWall = Rot::fromAngle(wall.angle).inverse();
    const Rot turned = wall.turn == 0 ? toWall : Rot::fromAngle(wall.angle + wall.turn).inverse();
    const double spin = std::fabs(wall.turn);
    const double bend = spin * (2 * (after - before).norm() + spin * std::max(before.norm(), after.norm())) / 8;
    return {toWall * before + wall.localCenter, turned * after + wall.localCenter, bend, way.turn - wall.turn};
}

/// May a body on this way have gone through a shape of a wall?
bool mayCross(const Passage& passage, const Shape& face, const BodyRecord& body, double core) {
    if (passage.travel(body) <= slow * core) return false;
    const Aabb line{passage.from.cwiseMin(passage.to), passage.from.cwiseMax(passage.to)};
    return overlap(inflate(line, body.extent + passage.bend), aabbOf(face, {}));
}

/// The first wall that a body crosses on its way through a part of the step.
std::optional<Hit> firstHit(const WorldState& world, BodyIndex body, const Way& way, const Past& past, bool onlyFixed) {
    const BodyRecord& record = world.bodies.record[body];
    const double core = record.core;
    std::optional<Hit> first;
    forEachNear(world, world.space, body, way, [&](ProxyId own, ProxyId other) {
        const BodyIndex wall = world.space[other].owner;
        if (!isWall(world, wall, onlyFixed)) return;
        const Way wallWay = freeWay(world, wall, past);
        const Shape& shape = world.space[own].def.shape;
        const Shape& face = world.space[other].def.shape;
        if (!mayCross(passageOf(wallWay, way), face, record, core)) return;
        const SweptShape swept{&shape, way, reachOf(shape, way.localCenter)};
        const std::optional<double> crossing = timeOfCrossing({&face, wallWay, 0}, swept);
        if (crossing && (!first || *crossing < first->time)) first = Hit{*crossing, wall, wallWay};
    });
    return first;
}

/// False, and nothing done, where there is no wall in the way.
bool stop(WorldState& world, BodyIndex body, const Way& way, const Past& past) {
    const std::optional<Hit> hit = firstHit(world, body, way, past, false);
    if (!hit) return false;
    Way stopped = stayAt(world, way, *hit);
    // What moves on carries it along, perhaps into what does not.
    if (world.bodies.record[hit->wall].type == BodyType::Kinematic) {
        const std::optional<Hit> fixed = firstHit(world, body, stopped, past, true);
        if (fixed) stopped = stayAt(world, stopped, *fixed);
    }
    BodyMotion motion = world.bodies.motion[body];
    motion.center = stopped.start + stopped.shift;
    motion.angle = stopped.angle + stopped.turn;
    motion.rotation = Rot::fromAngle(motion.angle);
    moveTo(world, body, motion);
    return true;
}

/// A dynamic body that was moved by the solver or by nothing.
bool isMoved(const BodyRecord& record) {
    return record.type == BodyType::Dynamic && record.awake && !record.flown && !record.quarantined;
}

/// Is this so far for a body of its size that it may have gone through something?
bool isFar(const WorldState& world, BodyIndex body, double travel) {
    return travel > slow * world.bodies.record[body].core;
}

/// Bodies that hardly move themselves, but as seen from a wall that comes along.
void addSwept(const WorldState& world, BodyIndex wall, const Way& wallWay, double dt,
              std::vector<BodyIndex>& suspects) {
    if (travelOf(wallWay, world.bodies.record[wall]) < sweeping) return;
    forEachContact(world.bodies, world.contacts, wall, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const BodyIndex other = contact.bodyA == wall ? contact.bodyB : contact.bodyA;
        const BodyRecord& record = world.bodies.record[other];
        if (!isMoved(record)) return;
        const Passage passage = passageOf(wallWay, wayOf(world, other, dt));
        if (isFar(world, other, passage.travel(record))) suspects.push_back(other);
    });
}

/// In the order of their slots, those that have moved far for their size, or past which a wall has.
std::vector<BodyIndex> findSuspects(const WorldState& world, double dt) {
    std::vector<BodyIndex> suspects;
    for (const BodyIndex body : world.bodies.awake) {
        const BodyRecord& record = world.bodies.record[body];
        const Way way = wayOf(world, body, dt);
        if (record.type == BodyType::Kinematic) addSwept(world, body, way, dt, suspects);
        if (isMoved(record) && isFar(world, body, travelOf(way, record))) suspects.push_back(body);
    }
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    return suspects;
}

/// Leg after leg, and a body that was stopped in one has none after it.
template <class SomeWorld>
void stopFlights(SomeWorld& world, double dt) {
    if constexpr (requires { world.legs; }) {
        std::vector<BodyIndex> stopped;
        for (const auto& leg : world.legs) {
            if (std::find(stopped.begin(), stopped.end(), leg.body) != stopped.end()) continue;
            const Way way = wayBetween(leg.from, leg.to, world.bodies.record[leg.body]);
            if (!isFar(world, leg.body, travelOf(way, world.bodies.record[leg.body]))) continue;
            if (stop(world, leg.body, way, {dt - leg.start, dt - leg.end})) stopped.push_back(leg.body);
        }
    }
}

}  // namespace

double coreOf(const Shape& shape) {
    return std::visit([](const auto& outline) { return coreOfOutline(outline); }, shape);
}

void stopAtWalls(WorldState& world, double dt) {
    for (const BodyIndex body : findSuspects(world, dt)) stop(world, body, wayOf(world, body, dt), {dt, 0});
    stopFlights(world, dt);
}

}  // namespace plumb
