// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/revolute_joint.h>

#include <algorithm>

namespace plumb {

namespace {

/// K x = b for K = mA (I + rho^2 terms of rA) + mB (...): what impulse gives the change of velocity b.
Vec2f solveMass(const Vec2f& b, float ma, const Vec2f& ra, float mb, const Vec2f& rb) {
    const float k11 = ma * (1 + ra.y() * ra.y()) + mb * (1 + rb.y() * rb.y());
    const float k12 = -ma * ra.x() * ra.y() - mb * rb.x() * rb.y();
    const float k22 = ma * (1 + ra.x() * ra.x()) + mb * (1 + rb.x() * rb.x());
    const float determinant = k11 * k22 - k12 * k12;
    if (determinant <= 0) return {0, 0};
    const float inverse = 1 / determinant;
    return {(k22 * b.x() - k12 * b.y()) * inverse, (k11 * b.y() - k12 * b.x()) * inverse};
}

}  // namespace

RevoluteJoint::RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies)
    : a_(anchorAt(def.bodyA.index, def.anchor, bodies)), b_(anchorAt(def.bodyB.index, def.anchor, bodies)) {}

void RevoluteJoint::prepare(const BodyStore& bodies, bool alone) {
    alone_ = alone;
    plumb::prepare(a_, bodies);
    plumb::prepare(b_, bodies);
    const BodyMotion& a = bodies.motion[a_.body];
    const BodyMotion& b = bodies.motion[b_.body];
    const Vec2 gap = (b.center - a.center) + (b.rotation * b_.local - a.rotation * a_.local);
    startGap_ = gap.cast<float>();
    total_.setZero();
}

void RevoluteJoint::warmStart(BodyStore& bodies) {
    push(a_, armOf(a_, bodies), -impulse_, bodies);
    push(b_, armOf(b_, bodies), impulse_, bodies);
}

void RevoluteJoint::solve(BodyStore& bodies, const JointPass& pass) {
    const Vec2f ra = armOf(a_, bodies);
    const Vec2f rb = armOf(b_, bodies);
    Vec2f wanted = velocityAt(b_, rb, bodies) - velocityAt(a_, ra, bodies);
    float massScale = 1;
    float impulseScale = 0;
    if (pass.correct) {
        const Softness& soft = alone_ ? pass.rigid : pass.soft;
        const Vec2f gap = startGap_ + (travelOf(b_, rb, bodies) - travelOf(a_, ra, bodies));
        const Vec2f bend = bendOf(b_, rb, pass.step, bodies) - bendOf(a_, ra, pass.step, bodies);
        const float rate = std::min(soft.biasRate, pass.pullSpeed / std::max(gap.norm(), 1e-9f));
        wanted += gap * rate - bend;
        massScale = soft.massScale;
        impulseScale = soft.impulseScale;
    }
    const float ma = bodies.velocity[a_.solver].inverseMass;
    const float mb = bodies.velocity[b_.solver].inverseMass;
    const Vec2f full = solveMass(wanted, ma, ra * a_.rho, mb, rb * b_.rho);
    const Vec2f change = -full * massScale - impulse_ * impulseScale;
    impulse_ += change;
    total_ += impulse_;
    push(a_, ra, -change, bodies);
    push(b_, rb, change, bodies);
}

}  // namespace plumb
