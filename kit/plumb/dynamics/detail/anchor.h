// SPDX-License-Identifier: MIT
// Where is a joint's end on a body now, and how does an impulse there move it?
#pragma once
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/body_store.h>

namespace plumb {

/// A point fixed to a body, followed through a step.
struct Anchor {
    Vec2 local{0, 0};  ///< from the centre of mass, in the body's frame [m]
    BodyIndex body = noBody;
    float rho = 1;
    Vec2f start{0, 0};  ///< from the centre of mass, turned with the body, at the step's start [m]
};

/// The anchor on a body at a point of the world, where the body stands now.
inline Anchor anchorAt(BodyIndex body, const Vec2& point, const BodyStore& bodies) {
    const BodyMotion& motion = bodies.motion[body];
    Anchor anchor;
    anchor.body = body;
    anchor.local = motion.rotation.inverse() * Vec2(point - motion.center);
    return anchor;
}

inline void prepare(Anchor& anchor, const BodyStore& bodies) {
    anchor.rho = bodies.record[anchor.body].rho;
    const Vec2 arm = bodies.motion[anchor.body].rotation * anchor.local;
    anchor.start = arm.cast<float>();
}

/// From the centre of mass to the anchor now [m].
inline Vec2f armOf(const Anchor& anchor, const BodyStore& bodies) {
    const SolverDisplacement& d = bodies.displacement[anchor.body];
    const Vec2f turned = anchor.start * (d.cosMinus1 * anchor.rho) + perp(anchor.start) * (d.sin * anchor.rho);
    return anchor.start + turned;
}

/// How far the anchor has come in this step, given its arm now [m].
inline Vec2f travelOf(const Anchor& anchor, const Vec2f& arm, const BodyStore& bodies) {
    const SolverDisplacement& d = bodies.displacement[anchor.body];
    return Vec2f(d.x, d.y) + (arm - anchor.start);
}

inline Vec2f velocityAt(const Anchor& anchor, const Vec2f& arm, const BodyStore& bodies) {
    const SolverVelocity& v = bodies.velocity[anchor.body];
    return Vec2f(v.x, v.y) + perp(arm) * (v.w * anchor.rho);
}

/// How far the anchor's way in the coming sub-step h bends off its tangent: omega^2 r h^2 / 2, divided by h. Counted up
/// to a tenth of a radian; beyond, in a joint that is breaking up, it would feed what it is to correct.
inline Vec2f bendOf(const Anchor& anchor, const Vec2f& arm, float h, const BodyStore& bodies) {
    const float angle = std::min(std::fabs(bodies.velocity[anchor.body].w * anchor.rho * h), 0.1f);
    return arm * (0.5f * angle * angle / h);
}

inline void push(const Anchor& anchor, const Vec2f& arm, const Vec2f& impulse, BodyStore& bodies) {
    SolverVelocity& v = bodies.velocity[anchor.body];
    v.x += v.inverseMass * impulse.x();
    v.y += v.inverseMass * impulse.y();
    v.w += v.inverseMass * anchor.rho * cross(arm, impulse);
}

}  // namespace plumb
