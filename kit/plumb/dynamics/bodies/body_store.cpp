// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/body_store.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {

namespace {

/// A coordinate as the sum of two floats, so that the difference of two places is as exact as a float can be,
/// everywhere in the world: a single float has steps of 8 mm at 100 km.
void putCenter(BodyPlace& place, const Vec2& center) {
    place.highX = static_cast<float>(center.x());
    place.highY = static_cast<float>(center.y());
    place.lowX = static_cast<float>(center.x() - static_cast<double>(place.highX));
    place.lowY = static_cast<float>(center.y() - static_cast<double>(place.highY));
}

// Of a coordinate or speed [m, m/s, rad, rad/s]: a double has steps of 0.1 m there. Beyond it a body is put in
// quarantine. Test: "a body flies on at 1e14 m/s up to 1e15 m from the origin, and is put in quarantine there"
constexpr double largest = 1e15;

bool isInRange(double value) {
    return std::fabs(value) < largest;  // false for nan
}

bool isInRange(const Vec2& value) {
    return isInRange(value.x()) && isInRange(value.y());
}

}  // namespace

BodyStore::BodyStore() {
    acquire();  // slot 0
}

/// The arrays by slot, and the lists that may name every body. An array that is left out here grows later; one that is
/// left out in acquire would be read beyond its end.
void BodyStore::reserve(std::size_t bodies) {
    motion.reserve(bodies);
    record.reserve(bodies);
    links.reserve(bodies);
    apart.reserve(bodies);
    watch.reserve(bodies);
    step.reserve(bodies);
    velocity.reserve(bodies);
    displacement.reserve(bodies);
    warm.reserve(bodies);
    before.reserve(bodies);
    turn.reserve(bodies);
    kick.reserve(bodies);
    place.reserve(bodies);
    awake.reserve(bodies);
    free.reserve(bodies);
}

/// A slot of a removed body, which release has reset, or a new one.
BodyIndex BodyStore::acquire() {
    if (!free.empty()) {
        const BodyIndex body = free.back();
        free.pop_back();
        return body;
    }
    motion.emplace_back();
    record.emplace_back();
    links.emplace_back();
    apart.emplace_back();
    watch.emplace_back();
    step.emplace_back();
    velocity.emplace_back();
    displacement.emplace_back();
    warm.emplace_back();
    before.emplace_back();
    turn.emplace_back();
    kick.emplace_back();
    place.emplace_back();
    return static_cast<BodyIndex>(record.size() - 1);
}

/// The generation goes up, so that ids of the removed body name no other. Test: "an id of a removed body is refused
/// even after its slot was used again"
void BodyStore::release(BodyIndex body) {
    putToSleep(body);
    std::erase(kinematic, body);
    const std::uint32_t generation = record[body].generation + 1;
    record[body] = {};
    record[body].generation = generation;
    links[body] = {};
    apart[body].clear();
    motion[body] = {};
    // Else the next body in this slot would be put in quarantine. Test: "a body told to fly at 1e300 m/s in its sleep
    // and removed leaves the next in its slot alone"
    std::erase(outOfRange, body);
    rest(body);
    free.push_back(body);
}

/// Only the body and the list; its contacts and neighbours are woken in islands/wake.cpp.
void BodyStore::wake(BodyIndex body) {
    BodyRecord& r = record[body];
    r.stillTime = 0;
    if (r.awake || r.type == BodyType::Static || !r.enabled) return;
    r.awake = true;
    r.awakeIndex = static_cast<std::uint32_t>(awake.size());
    awake.push_back(body);
}

void BodyStore::putToSleep(BodyIndex body) {
    BodyRecord& r = record[body];
    if (!r.awake) return;
    // The last one moves into the gap: O(1). So awake has no order that means anything.
    const BodyIndex last = awake.back();
    awake[r.awakeIndex] = last;
    record[last].awakeIndex = r.awakeIndex;
    awake.pop_back();
    r.awake = false;
    r.awakeIndex = none;
    rest(body);
}

/// A body without motion, as the narrow phase and the solver see it: inverse mass 0, so that no impulse moves it. For
/// bodies that sleep or are in quarantine, for static ones, and for slot 0.
void BodyStore::rest(BodyIndex body) {
    place[body] = placeOf(motion[body], record[body].inverseGyration);
    step[body].movedBy = MovedBy::Nothing;
    velocity[body] = warm[body] = before[body] = {};
    displacement[body] = {};
    turn[body] = {};
    kick[body] = {};
}

/// Edits move a centre of mass between steps. Then the place where the step began moves with it, because queries
/// measure from there how far the body has come. Test: "it is found there too when its centre of mass is put back to
/// where it was before the step"
void BodyStore::recenterPlace(BodyIndex body, const Vec2& shift) {
    BodyPlace& then = place[body];
    const Rot turned{static_cast<double>(then.cos), static_cast<double>(then.sin)};
    const Vec2 center(static_cast<double>(then.highX) + static_cast<double>(then.lowX),
                      static_cast<double>(then.highY) + static_cast<double>(then.lowY));
    putCenter(then, center + turned * shift);
}

bool BodyStore::areKeptApart(BodyIndex a, BodyIndex b) const {
    return std::find(apart[a].begin(), apart[a].end(), b) != apart[a].end();
}

bool isInRange(const BodyMotion& m) {
    return isInRange(m.center) && isInRange(m.velocity) && isInRange(m.angle) && isInRange(m.angularVelocity);
}

bool isInRange(const Acceleration& a) {
    return isInRange(a.linear) && isInRange(a.angular);
}

/// Phases store motions through this: numbers that are out of range go no further. The body keeps its last state, and
/// the next takeOut of the step puts it in quarantine.
void storeMotion(BodyStore& bodies, BodyIndex body, const BodyMotion& motion) {
    if (isInRange(motion))
        bodies.motion[body] = motion;
    else
        markOutOfRange(bodies, body);
}

void BodyStore::notePlaced(BodyIndex body) {
    if (!std::exchange(step[body].placed, true)) placed.push_back(body);
}

void clearPlaced(BodyStore& bodies) {
    for (const BodyIndex body : bodies.placed) bodies.step[body].placed = false;
    bodies.placed.clear();
}

void clearForces(BodyStore& bodies) {
    for (const BodyIndex body : bodies.forced) {
        bodies.record[body].force.setZero();
        bodies.record[body].torque = 0;
    }
    bodies.forced.clear();
}

void markOutOfRange(BodyStore& bodies, BodyIndex body) {
    if (bodies.record[body].quarantined) return;
    bodies.record[body].quarantined = true;
    bodies.outOfRange.push_back(body);
}

BodyPlace placeOf(const BodyMotion& motion, float inverseGyration) {
    BodyPlace place;
    putCenter(place, motion.center);
    place.cos = static_cast<float>(motion.rotation.cos);
    place.sin = static_cast<float>(motion.rotation.sin);
    place.inverseGyration = inverseGyration;
    return place;
}

Acceleration accelerationOf(const BodyRecord& body, const Vec2& gravity) {
    if (body.type != BodyType::Dynamic) return {};
    return {gravity * body.gravityScale + body.force * body.inverseMass,
            body.inverseInertia > 0 ? body.torque * body.inverseInertia : 0.0};
}

void setMass(BodyRecord& body, const Mass& mass) {
    body.localCenter = mass.center;
    if (body.type != BodyType::Dynamic) {
        body.mass = body.inertia = body.inverseMass = body.inverseInertia = 0;
        // Not 0, as for a body that cannot turn: w = omega / rho carries the spin of a kinematic body, which its
        // contacts need.
        body.inverseGyration = body.gyration = 1;
        return;
    }
    body.mass = mass.mass;
    body.inertia = mass.inertia;
    body.inverseMass = 1 / mass.mass;
    body.inverseInertia = body.fixedRotation ? 0 : 1 / mass.inertia;
    setGyration(body, body.inverseInertia);
}

/// rho = sqrt(m / I) [1/m], m mass [kg], I inertia [kg m^2], see SolverVelocity. A body that cannot turn has rho 0 and
/// radius 0: then no impulse and no spin gets through.
void setGyration(BodyRecord& body, double inverseInertia) {
    const double inverseGyration = std::sqrt(inverseInertia * body.mass);
    body.inverseGyration = static_cast<float>(inverseGyration);
    body.gyration = inverseGyration > 0 ? static_cast<float>(1 / inverseGyration) : 0.0f;
}

}  // namespace plumb
