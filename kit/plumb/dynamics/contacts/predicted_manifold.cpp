// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/predicted_manifold.h>

#include <algorithm>

#include <plumb/dynamics/bodies/time_of_impact.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

namespace {

MovingShape movingShape(const BodyStore& bodies, BodyIndex body, const Proxy& proxy) {
    const BodyRecord& record = bodies.record[body];
    MovingShape shape;
    shape.shape = &proxy.def.shape;
    shape.localCenter = record.localCenter;
    shape.boundingRadius = record.boundingRadius;
    shape.from = bodies.motion[body];
    if (record.awake) shape.law = flightLawOf(bodies, body);
    return shape;
}

}  // namespace

RelativePose relativePose(const BodyMotion& a, const BodyMotion& b) {
    const Rot toA = a.rotation.inverse();
    const Vec2 shift = toA * Vec2(b.center - a.center);
    const Rot turn = toA * b.rotation;
    return {shift.cast<float>(), static_cast<float>(turn.cos), static_cast<float>(turn.sin)};
}

FoundManifold predictedManifold(const BodyStore& bodies, const Space& space, const ShapePair& pair, float margin,
                                double dt) {
    const Proxy& proxyA = space[pair.proxyA];
    const Proxy& proxyB = space[pair.proxyB];
    const MovingShape a = movingShape(bodies, pair.bodyA, proxyA);
    MovingShape b = movingShape(bodies, pair.bodyB, proxyB);
    b.from.center += Vec2(pair.shiftX, pair.shiftY);
    const std::optional<double> time = timeOfImpact(a, b, 0, dt);
    if (!time) return {};
    const Encounter meeting = encounterAt(a, b, *time);
    Manifold m = manifold(proxyA.convex, proxyB.convex, relativePose(meeting.a, meeting.b), contactMargin);
    // The normal, and the arms from both centres of mass, are those of the meeting, in the world; so impulses act there
    // as they do when the two meet. They are stored in the frame that A has at the step's start. A point's separation
    // is what the solver's formula has to begin with, so that the gap is closed at the meeting.
    const Rot turnA = meeting.a.rotation * a.from.rotation.inverse();
    const Rot turnB = meeting.b.rotation * b.from.rotation.inverse();
    const Vec2 apart = meeting.b.center - meeting.a.center;
    const Vec2 normal = meeting.a.rotation * Vec2(m.normal.cast<double>());
    for (ManifoldPoint& point : m.points) {
        const Vec2 armA = meeting.a.rotation * Vec2(point.position.cast<double>()), armB = armA - apart;
        const Vec2 startA = a.from.center + 2 * armA - turnA * armA;
        const Vec2 startB = b.from.center + 2 * armB - turnB * armB;
        point.separation += static_cast<float>((startB - startA).dot(normal));
        point.separation = std::min(point.separation, margin);
        point.position = Vec2(a.from.rotation.inverse() * armA).cast<float>();
    }
    m.normal = Vec2(a.from.rotation.inverse() * normal).cast<float>();
    return {m, true, apart};
}

}  // namespace plumb
