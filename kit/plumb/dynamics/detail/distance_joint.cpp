// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/distance_joint.h>

#include <algorithm>

namespace plumb {

DistanceJoint::DistanceJoint(const DistanceJointDef& def, const BodyStore& bodies)
    : a_(anchorAt(def.bodyA.index, def.anchorA, bodies)), b_(anchorAt(def.bodyB.index, def.anchorB, bodies)) {
    length_ = static_cast<float>(def.length.value_or((def.anchorB - def.anchorA).norm()));
}

void DistanceJoint::prepare(const BodyStore& bodies, bool alone) {
    alone_ = alone;
    plumb::prepare(a_, bodies);
    plumb::prepare(b_, bodies);
    const BodyMotion& a = bodies.motion[a_.body];
    const BodyMotion& b = bodies.motion[b_.body];
    const Vec2 apart = (b.center - a.center) + (b.rotation * b_.local - a.rotation * a_.local);
    start_ = apart.cast<float>();
    total_.setZero();
}

Vec2f DistanceJoint::between(const Vec2f& ra, const Vec2f& rb, const BodyStore& bodies) const {
    return start_ + (travelOf(b_, rb, bodies) - travelOf(a_, ra, bodies));
}

void DistanceJoint::warmStart(BodyStore& bodies) {
    const Vec2f ra = armOf(a_, bodies);
    const Vec2f rb = armOf(b_, bodies);
    const Vec2f impulse = between(ra, rb, bodies).stableNormalized() * impulse_;
    push(a_, ra, -impulse, bodies);
    push(b_, rb, impulse, bodies);
}

void DistanceJoint::solve(BodyStore& bodies, const JointPass& pass) {
    const Vec2f ra = armOf(a_, bodies);
    const Vec2f rb = armOf(b_, bodies);
    const Vec2f d = between(ra, rb, bodies);
    const Vec2f u = d.stableNormalized();
    const Vec2f speed = velocityAt(b_, rb, bodies) - velocityAt(a_, ra, bodies);
    float wanted = u.dot(speed);
    float massScale = 1;
    float impulseScale = 0;
    if (pass.correct) {
        const Softness& soft = alone_ ? pass.rigid : pass.soft;
        const Vec2f bend = bendOf(b_, rb, pass.step, bodies) - bendOf(a_, ra, pass.step, bodies);
        const float gap = d.norm() - length_;
        const Vec2f step = (speed - bend) * pass.step;
        // |d + step| - |d|, without the cancellation of two nearly equal lengths
        const float sum = (d + step).norm() + d.norm();
        const float growth = sum > 0 ? step.dot(d + (d + step)) / sum : 0.0f;
        wanted = growth / pass.step + std::clamp(gap * soft.biasRate, -pass.pullSpeed, pass.pullSpeed);
        massScale = soft.massScale;
        impulseScale = soft.impulseScale;
    }
    const float ma = bodies.velocity[a_.body].inverseMass;
    const float mb = bodies.velocity[b_.body].inverseMass;
    const float ca = a_.rho * cross(ra, u);
    const float cb = b_.rho * cross(rb, u);
    const float k = ma * (1 + ca * ca) + mb * (1 + cb * cb);
    const float change = k > 0 ? -wanted * massScale / k - impulse_ * impulseScale : 0.0f;
    impulse_ += change;
    total_ += u * impulse_;
    push(a_, ra, -u * change, bodies);
    push(b_, rb, u * change, bodies);
}

}  // namespace plumb
