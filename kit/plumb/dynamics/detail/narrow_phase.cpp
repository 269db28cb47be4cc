// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/narrow_phase.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/time_of_impact.h>

namespace plumb {

namespace {

/// Boxes hold what they need for this step and this much more, so that what hardly moves keeps its box [m].
constexpr double boxMargin = 0.02;
/// Shapes this near count as in contact, so that what rests keeps its manifold while it trembles [m].
constexpr double contactMargin = 0.01;

/// More friction than this makes no difference, and might leave the solver's floats [-].
constexpr double roughest = 1e6;

/// What comes nearer than this to a sleeper, or may in the step, wakes it [m].
constexpr double trembling = 5e-4;

/// How far a body's centre moves in the step, and how far turning takes a point of it at most [m].
struct Reach {
    Vec2 shift{0, 0};
    double turn = 0;
};

Reach reachOf(const WorldState& world, BodyIndex body, double dt) {
    const BodyRecord& record = world.bodies.record[body];
    const BodyMotion& motion = world.bodies.motion[body];
    if (!record.awake) return {};
    const Acceleration a = accelerationOf(record, world.def.gravity);
    const double angle = (std::fabs(motion.angularVelocity) + std::fabs(a.angular) * dt) * dt;
    return {motion.velocity * dt + a.linear * (0.5 * dt * dt), record.extent * std::min(angle, 2.0)};
}

}  // namespace

void placeBody(WorldState& world, BodyIndex body, double dt) {
    const Reach reach = reachOf(world, body, dt);
    const Transform pose = world.bodies.pose(body);
    for (const ProxyId proxy : world.bodies.record[body].proxies) {
        const ShapeDef& shape = world.space[proxy].def;
        const Aabb now = inflate(aabbOf(shape.shape, pose), 0.5 * contactMargin + reach.turn);
        Aabb swept = merge(now, {now.lower + reach.shift, now.upper + reach.shift});
        if (shape.material.restitution > 0) swept = inflate(now, reach.shift.norm());  // it may bounce any way
        world.space.place(proxy, swept, boxMargin);
    }
}

namespace {

bool joinedApart(const WorldState& world, BodyIndex a, BodyIndex b) {
    const auto& joints = world.bodies.record[a].joints;
    return std::any_of(joints.begin(), joints.end(), [&](std::uint32_t j) {
        const JointRecord& joint = world.joints[j];
        return !joint.collideConnected && (joint.bodyA == b || joint.bodyB == b);
    });
}

void addContact(WorldState& world, const Pair& pair) {
    const Proxy& a = world.space[pair.a];
    const Proxy& b = world.space[pair.b];
    if (!world.bodies.isDynamic(a.owner) && !world.bodies.isDynamic(b.owner)) return;
    if (joinedApart(world, a.owner, b.owner)) return;
    ContactRecord contact;
    contact.proxyA = pair.a;
    contact.proxyB = pair.b;
    contact.bodyA = a.owner;
    contact.bodyB = b.owner;
    contact.friction = std::min(std::sqrt(a.def.material.friction * b.def.material.friction), roughest);
    contact.restitution = std::max(a.def.material.restitution, b.def.material.restitution);
    const ContactIndex index = world.contacts.add(world.bodies, contact);
    if (world.bodies.record[a.owner].awake || world.bodies.record[b.owner].awake) {
        world.contacts.activate(index);
    } else {  // something that rests was put there
        wakeIsland(world, a.owner);
        wakeIsland(world, b.owner);
    }
}

double marginOf(const WorldState& world, const ContactRecord& contact, double dt) {
    const Reach a = reachOf(world, contact.bodyA, dt);
    const Reach b = reachOf(world, contact.bodyB, dt);
    return contactMargin + (b.shift - a.shift).norm() + a.turn + b.turn;
}

RelativePose relativePose(const BodyMotion& a, const BodyMotion& b) {
    const Rot toA = a.rotation.inverse();
    const Vec2 shift = toA * Vec2(b.center - a.center);
    const Rot turn = toA * b.rotation;
    return {shift.cast<float>(), static_cast<float>(turn.cos), static_cast<float>(turn.sin)};
}

/// Which points of the manifold before are these? Those of the same features; and then, as where a box that sits almost
/// flush on its like is cut by now the one's corner and now the other's, those that were here and are nobody's yet.
std::array<int, 2> predecessors(const Manifold& was, const Manifold& now) {
    std::array<int, 2> found{-1, -1};
    std::array<bool, 2> claimed{false, false};
    const auto match = [&](const auto& isSame) {
        for (std::size_t p = 0; p < static_cast<std::size_t>(now.count); ++p) {
            for (std::size_t q = 0; q < static_cast<std::size_t>(was.count); ++q) {
                if (found[p] >= 0 || claimed[q] || !isSame(now.points[p], was.points[q])) continue;
                found[p] = static_cast<int>(q);
                claimed[q] = true;
            }
        }
    };
    match([](const ManifoldPoint& a, const ManifoldPoint& b) { return a.feature == b.feature; });
    match([](const ManifoldPoint& a, const ManifoldPoint& b) {
        const Vec2f moved = a.position - b.position;
        return moved.norm() < static_cast<float>(contactMargin);
    });
    return found;
}

/// Impulses follow their points into the new manifold; a new point starts without.
void carryImpulses(WorldState& world, ContactRecord& contact, const Manifold& now) {
    const std::array<PointMemory, 2> old = world.graph.memoryOf(contact);
    const std::array<int, 2> from = predecessors(contact.manifold, now);
    std::array<PointMemory, 2> carried{};
    for (std::size_t p = 0; p < 2; ++p) {
        if (from[p] < 0) continue;
        const PointMemory& point = old[static_cast<std::size_t>(from[p])];
        carried[p] = {point.normalImpulse, point.tangentImpulse, 0, 0};
    }
    contact.memory = carried;
    if (contact.colour >= 0) world.graph.setImpulses(contact, carried);
}

FlyingShape flyingShape(const WorldState& world, BodyIndex body, const Proxy& proxy) {
    const BodyRecord& record = world.bodies.record[body];
    FlyingShape shape;
    shape.shape = &proxy.def.shape;
    shape.localCenter = record.localCenter;
    shape.extent = record.extent;
    shape.from = world.bodies.motion[body];
    if (record.awake) shape.law = flightLawOf(record, world.def.gravity);
    return shape;
}

/// A contact that is still apart: it is one where and when the two meet in this step, and with that normal, not with
/// the one that they have from afar: what flies past a corner is not to be held up by the corner's face.
Manifold foreseen(const WorldState& world, const ContactRecord& contact, float margin, double dt) {
    const FlyingShape a = flyingShape(world, contact.bodyA, world.proxyA(contact));
    const FlyingShape b = flyingShape(world, contact.bodyB, world.proxyB(contact));
    const std::optional<double> time = timeOfImpact(a, b, 0, dt);
    if (!time) return {};
    const Encounter meeting = encounterAt(a, b, *time);
    Manifold m = manifold(world.proxyA(contact).convex, world.proxyB(contact).convex,
                          relativePose(meeting.a, meeting.b), static_cast<float>(contactMargin));
    // Back to the step's start: how far each point of B still has to come along the normal. Points stay with A.
    const Rot back = meeting.a.rotation * a.from.rotation.inverse();
    const Vec2 normal = meeting.a.rotation * Vec2(m.normal.cast<double>());
    for (ManifoldPoint& point : m.points) {
        const Vec2 local = point.position.cast<double>();
        const Vec2 at = meeting.a.center + meeting.a.rotation * local;
        const Vec2 armB = (meeting.b.rotation.inverse() * b.from.rotation) * Vec2(at - meeting.b.center);
        const Vec2 startA = a.from.center + back.inverse() * Vec2(at - meeting.a.center);
        const Vec2 startB = b.from.center + armB;
        point.separation += static_cast<float>((startB - startA).dot(normal));
        point.separation = std::min(point.separation, margin);
    }
    m.normal = Vec2(back * Vec2(m.normal.cast<double>())).cast<float>();
    return m;
}

float nearestOf(const Manifold& m, float none) {
    float nearest = none;
    for (int p = 0; p < m.count; ++p) nearest = std::min(nearest, m.points[static_cast<std::size_t>(p)].separation);
    return nearest;
}

void updateManifold(WorldState& world, ContactRecord& contact, double dt) {
    const RelativePose pose = relativePose(world.bodies.motion[contact.bodyA], world.bodies.motion[contact.bodyB]);
    const float margin = static_cast<float>(marginOf(world, contact, dt));
    Manifold now = manifold(world.proxyA(contact).convex, world.proxyB(contact).convex, pose, margin);
    if (now.count > 0 && nearestOf(now, margin) > static_cast<float>(contactMargin))
        now = foreseen(world, contact, margin, dt);
    carryImpulses(world, contact, now);
    contact.manifold = now;
    if (now.count == 0) return;
    if (nearestOf(now, margin) > margin - static_cast<float>(contactMargin - trembling)) return;
    for (const BodyIndex body : {contact.bodyA, contact.bodyB})
        if (world.bodies.isDynamic(body) && !world.bodies.record[body].awake) wakeIsland(world, body);
}

}  // namespace

void pairShapes(WorldState& world, BodyIndex a, BodyIndex b) {
    for (const ProxyId pa : world.bodies.record[a].proxies)
        for (const ProxyId pb : world.bodies.record[b].proxies)
            if (mayPair(world.space[pa], world.space[pb]) &&
                overlap(world.space[pa].previousBox, world.space[pb].previousBox))
                addContact(world, {std::min(pa, pb), std::max(pa, pb)});
}

void findContacts(WorldState& world, double dt) {
    for (const BodyIndex body : world.bodies.awake) placeBody(world, body, dt);
    for (const Pair& pair : world.space.takeNewPairs()) addContact(world, pair);
    for (std::size_t i = 0; i < world.contacts.active.size();) {
        const ContactIndex index = world.contacts.active[i];
        ContactRecord& contact = world.contacts.contacts[index];
        if (!overlap(world.proxyA(contact).box, world.proxyB(contact).box)) {
            removeContact(world, index);
            continue;
        }
        updateManifold(world, contact, dt);
        ++i;
    }
}

}  // namespace plumb
