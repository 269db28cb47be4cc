// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/predicted_manifold.h>

#include <algorithm>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/bodies/time_of_impact.h>

namespace plumb {

namespace {

MovingShape movingShape(const BodyStore& bodies, BodyIndex body, const Proxy& proxy) {
    const BodyRecord& record = bodies.record[body];
    MovingShape shape;
    shape.shape = &proxy.def.shape;
    shape.localCenter = record.localCenter;
    shape.boundingRadius = record.boundingRadius;
    shape.from = bodies.motion[body];
    // A body that sleeps has no motion, though gravity would act on it.
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

Manifold predictedManifold(const BodyStore& bodies, const Space& space, const ShapePair& pair, float margin,
                           double dt) {
    const Proxy& proxyA = space[pair.proxyA];
    const Proxy& proxyB = space[pair.proxyB];
    const MovingShape a = movingShape(bodies, pair.bodyA, proxyA);
    MovingShape b = movingShape(bodies, pair.bodyB, proxyB);
    b.from.center += Vec2(pair.shiftX, pair.shiftY);
    const std::optional<double> time = timeOfImpact(a, b, 0, dt);
    if (!time) return {};
    const BodyMotion metA = moveFreely(a.from, a.law, *time), metB = moveFreely(b.from, b.law, *time);
    Manifold m = manifold(proxyA.convex, proxyB.convex, relativePose(metA, metB), contactMargin);
    // Transform back to the step's start. A point's separation there is the distance that it has to close along the
    // normal. Points keep their places in A's frame.
    const Rot back = metA.rotation * a.from.rotation.inverse();
    const Vec2 normal = metA.rotation * Vec2(m.normal.cast<double>());
    for (ManifoldPoint& point : m.points) {
        const Vec2 local = point.position.cast<double>();
        const Vec2 at = metA.center + metA.rotation * local;
        const Vec2 armB = (metB.rotation.inverse() * b.from.rotation) * Vec2(at - metB.center);
        const Vec2 startA = a.from.center + back.inverse() * Vec2(at - metA.center);
        const Vec2 startB = b.from.center + armB;
        point.separation += static_cast<float>((startB - startA).dot(normal));
        // A point at the other end of a face may have a long way to go; the solver needs only to know that it is not
        // near.
        point.separation = std::min(point.separation, margin);
    }
    m.normal = Vec2(back * Vec2(m.normal.cast<double>())).cast<float>();
    return m;
}

}  // namespace plumb
