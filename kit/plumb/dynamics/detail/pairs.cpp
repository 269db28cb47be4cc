// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/pairs.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <plumb/dynamics/detail/contact_rules.h>
#include <plumb/dynamics/detail/fresh_lanes.h>
#include <plumb/dynamics/detail/islands.h>
#include <plumb/dynamics/detail/sensors.h>
#include <plumb/dynamics/detail/shape_measure.h>

namespace plumb {

namespace {

/// Boxes hold what they need for this step and this much more, so that what hardly moves keeps its box [m].
constexpr double boxMargin = 0.01;

/// More friction than this makes no difference, and might leave the solver's floats [-].
constexpr double roughest = 1e6;

Aabb tightBox(const WorldState& world, ProxyId proxy, const BodyMotion& motion, const Transform& pose) {
    const BoxOutline& box = world.contacts.boxes[proxy];
    if (box.kind == BoxOutline::Kind::Other) return aabbOf(world.space[proxy].def.shape, pose);
    const double c = motion.rotation.cos;
    const double s = motion.rotation.sin;
    const double x = static_cast<double>(box.centerX), y = static_cast<double>(box.centerY);
    const double hx = static_cast<double>(box.halfX), hy = static_cast<double>(box.halfY);
    const Vec2 center(motion.center.x() + (c * x - s * y), motion.center.y() + (s * x + c * y));
    const Vec2 half(std::fabs(c) * hx + std::fabs(s) * hy, std::fabs(s) * hx + std::fabs(c) * hy);
    return inflate({center - half, center + half}, static_cast<double>(box.radius));
}

/// A sensor has no part in the reach of its body.
double sensorTurn(const WorldState& world, ProxyId proxy, const BodyRecord& record, const BodyMotion& motion,
                  double dt) {
    return reachOf(world.space[proxy].def.shape, record.localCenter) *
           std::min(std::fabs(motion.angularVelocity) * dt, 2.0);
}

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

/// Both radii of rounding: what rolls on what.
double roundingOf(const Proxy& a, const Proxy& b) {
    return static_cast<double>(std::max(a.convex.radius, b.convex.radius));
}

ContactRecord contactOf(const WorldState& world, const Pair& pair, const Vec2& shift) {
    const Proxy& a = world.space[pair.a];
    const Proxy& b = world.space[pair.b];
    ContactRecord contact;
    contact.proxyA = pair.a;
    contact.proxyB = pair.b;
    contact.bodyA = a.owner;
    contact.bodyB = b.owner;
    contact.shift = shift;
    const auto isBox = [&](ProxyId proxy) { return world.contacts.boxes[proxy].kind == BoxOutline::Kind::Box; };
    contact.boxes = isBox(pair.a) && isBox(pair.b);
    contact.ruled = hasRule(a.def) || hasRule(b.def);
    mixMaterials(world, contact);
    return contact;
}

/// shift: of b, by which it overlaps a.
void addContact(WorldState& world, const Pair& pair, const Vec2& shift) {
    if (world.space[pair.a].def.sensor || world.space[pair.b].def.sensor) {
        addSensorPair(world, pair, shift);
        return;
    }
    const BodyIndex a = world.space[pair.a].owner;
    const BodyIndex b = world.space[pair.b].owner;
    if (!world.bodies.isDynamic(a) && !world.bodies.isDynamic(b)) return;
    if (joinedApart(world, a, b)) return;
    const ContactIndex index = world.contacts.add(world.bodies, contactOf(world, pair, shift));
    if (world.bodies.record[a].awake || world.bodies.record[b].awake) {
        world.contacts.addNear(index);
    } else if (!world.bodies.isDynamic(a) || !world.bodies.isDynamic(b)) {  // something that rests was put there
        wakeIsland(world, a);
        wakeIsland(world, b);
    }
}

/// shift: of b.
void addContact(WorldState& world, ProxyId a, ProxyId b, const Vec2& shift) {
    if (a < b)
        addContact(world, {a, b}, shift);
    else
        addContact(world, {b, a}, -shift);
}

bool isPaired(const WorldState& world, ProxyId a, ProxyId b, const Vec2& shift) {
    const BodyIndex owner = world.space[a].owner;
    const BodyIndex body = world.bodies.isDynamic(owner) ? owner : world.space[b].owner;
    bool paired = false;
    forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = world.contacts.contacts[index];
        paired = paired || (contact.proxyA == a && contact.proxyB == b && contact.shift == shift) ||
                 (contact.proxyA == b && contact.proxyB == a && contact.shift == -shift);
    });
    return paired;
}

}  // namespace

void mixMaterials(const WorldState& world, ContactRecord& contact) {
    const Proxy& a = world.proxyA(contact);
    const Proxy& b = world.proxyB(contact);
    const Material& ma = a.def.material;
    const Material& mb = b.def.material;
    contact.friction = std::min(mixed(ma.friction, mb.friction, ma.frictionMix, mb.frictionMix), roughest);
    contact.restitution = mixed(ma.restitution, mb.restitution, ma.restitutionMix, mb.restitutionMix);
    const double reach = std::max(ma.rollingResistance, mb.rollingResistance) * roundingOf(a, b);
    contact.rollingReach = static_cast<float>(std::min(reach, roughest));
    contact.beltSpeed = static_cast<float>(ma.surfaceSpeed + mb.surfaceSpeed);
}

bool joinedApart(const WorldState& world, BodyIndex a, BodyIndex b) {
    const auto& joints = world.bodies.record[a].joints;
    return std::any_of(joints.begin(), joints.end(), [&](std::uint32_t j) {
        const JointRecord& joint = world.joints[j];
        return !joint.collideConnected && (joint.bodyA == b || joint.bodyB == b);
    });
}

Vec2 foreseenShift(const WorldState& world, BodyIndex body) {
    const BodyPlace& place = world.bodies.place[body];
    const Vec2 shift(static_cast<double>(place.shiftX), static_cast<double>(place.shiftY));
    const Wrap& wrap = world.def.wrap;
    if (!wrap.any()) return shift;
    const bool round =
        (wrap.width && std::fabs(shift.x()) > *wrap.width) || (wrap.height && std::fabs(shift.y()) > *wrap.height);
    return round ? Vec2(0, 0) : shift;
}

void placeBody(WorldState& world, BodyIndex body, double dt) {
    const BodyRecord& record = world.bodies.record[body];
    const BodyMotion& motion = world.bodies.motion[body];
    const BodyPlace& place = world.bodies.place[body];
    const bool moves = record.awake && dt > 0;
    const Vec2 shift = moves ? foreseenShift(world, body) : Vec2(0, 0);
    const double turn = moves ? static_cast<double>(place.turn) : 0.0;
    const Transform pose = world.bodies.pose(body);
    for (const ProxyId proxy : record.proxies) {
        const bool sensor = world.contacts.boxes[proxy].sensor;
        const double swing = sensor && moves ? sensorTurn(world, proxy, record, motion, dt) : turn;
        const Aabb now =
            inflate(tightBox(world, proxy, motion, pose), 0.5 * static_cast<double>(contactMargin) + swing);
        const Aabb ahead{now.lower + shift, now.upper + shift};
        // It may come back from anywhere, as fast as its restitution lets it.
        const Aabb back = inflate(now, static_cast<double>(world.contacts.boxes[proxy].restitution) * shift.norm());
        world.space.place(proxy, merge(ahead, back), boxMargin);
    }
}

void pairShapes(WorldState& world, BodyIndex a, BodyIndex b) {
    if (!world.bodies.record[a].enabled || !world.bodies.record[b].enabled) return;
    const auto isSensor = [&world](ProxyId proxy) { return world.space[proxy].def.sensor; };  // is not kept apart
    for (const ProxyId pa : world.bodies.record[a].proxies)
        for (const ProxyId pb : world.bodies.record[b].proxies)
            if (!isSensor(pa) && !isSensor(pb) && mayPair(world.space[pa], world.space[pb]))
                world.space.forEachPreviousShift(pa, pb, [&](const Vec2& shift) { addContact(world, pa, pb, shift); });
}

void pairShape(WorldState& world, ProxyId proxy) {
    struct Other {
        ProxyId proxy;
        Vec2 shift;
    };
    std::vector<Other> others;
    world.space.query(world.space.box(proxy), [&](ProxyId other, const Vec2& shift) {
        if (mayPair(world.space[proxy], world.space[other]) && world.space.previousBoxesOverlap(proxy, other, shift))
            others.push_back({other, shift});
    });
    std::sort(others.begin(), others.end(), [](const Other& a, const Other& b) {
        return std::tuple(a.proxy, a.shift.x(), a.shift.y()) < std::tuple(b.proxy, b.shift.x(), b.shift.y());
    });
    for (const Other& other : others)
        if (!isPaired(world, proxy, other.proxy, other.shift)) addContact(world, proxy, other.proxy, other.shift);
}

void findPairs(WorldState& world) {
    const SortedPairs& pairs = world.space.takeNewPairs();
    const std::span<const Vec2> shifts = world.space.newPairShifts();
    for (std::size_t i = 0; i < pairs.size(); ++i) addContact(world, pairs[i], shifts.empty() ? Vec2(0, 0) : shifts[i]);
}

}  // namespace plumb
