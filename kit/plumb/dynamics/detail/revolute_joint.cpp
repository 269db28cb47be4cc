// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/revolute_joint.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {

namespace {

/// Beyond this a motor's numbers would leave the solver's floats; a torque counts as infinite then.
constexpr double largest = 1e30;

/// Turning counts as held by the hinge, so that no motor can do anything, where it has less than this of the freedom
/// that it would have without [-].
constexpr float held = 1e-6f;

float speedOf(double speed) {
    return static_cast<float>(std::clamp(speed, -largest, largest));
}

float torqueOf(double torque) {
    return torque > largest ? std::numeric_limits<float>::infinity() : static_cast<float>(torque);
}

}  // namespace

/// K = mA (I + rho^2 terms of rA) + mB (...), and what belongs to the turning.
struct RevoluteJoint::Masses {
    float k11 = 0, k12 = 0, k22 = 0;
    float inverseInertia = 0;  ///< of both together [1/(kg m^2)]
    Vec2f u{0, 0};

    /// K x = b: what impulse gives the change of velocity b.
    Vec2f solve(const Vec2f& b) const {
        const float determinant = k11 * k22 - k12 * k12;
        if (determinant <= 0) return {0, 0};
        const float inverse = 1 / determinant;
        return {(k22 * b.x() - k12 * b.y()) * inverse, (k11 * b.y() - k12 * b.x()) * inverse};
    }
};

RevoluteJoint::RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies)
    : a_(anchorAt(def.bodyA.index, def.anchor, bodies)),
      b_(anchorAt(def.bodyB.index, def.anchor, bodies)),
      speed_(speedOf(def.motorSpeed)),
      torque_(torqueOf(def.maxMotorTorque)) {}

void RevoluteJoint::prepare(const BodyStore& bodies, bool alone) {
    alone_ = alone;
    plumb::prepare(a_, bodies);
    plumb::prepare(b_, bodies);
    const BodyMotion& a = bodies.motion[a_.body];
    const BodyMotion& b = bodies.motion[b_.body];
    const Vec2 gap = (b.center - a.center) + (b.rotation * b_.local - a.rotation * a_.local);
    startGap_ = gap.cast<float>();
    total_.setZero();
    totalTurn_ = 0;
}

RevoluteJoint::Masses RevoluteJoint::massesOf(const BodyStore& bodies, const Vec2f& ra, const Vec2f& rb) const {
    const float ma = bodies.velocity[a_.body].inverseMass;
    const float mb = bodies.velocity[b_.body].inverseMass;
    const Vec2f sa = ra * a_.rho;
    const Vec2f sb = rb * b_.rho;
    Masses masses;
    masses.k11 = ma * (1 + sa.y() * sa.y()) + mb * (1 + sb.y() * sb.y());
    masses.k12 = -ma * sa.x() * sa.y() - mb * sb.x() * sb.y();
    masses.k22 = ma * (1 + sa.x() * sa.x()) + mb * (1 + sb.x() * sb.x());
    masses.inverseInertia = ma * a_.rho * a_.rho + mb * b_.rho * b_.rho;
    masses.u = perp(sa) * (ma * a_.rho) + perp(sb) * (mb * b_.rho);
    return masses;
}

void RevoluteJoint::turn(BodyStore& bodies, float impulse) const {
    SolverVelocity& a = bodies.velocity[a_.body];
    SolverVelocity& b = bodies.velocity[b_.body];
    a.w -= a.inverseMass * a_.rho * impulse;
    b.w += b.inverseMass * b_.rho * impulse;
}

void RevoluteJoint::warmStart(BodyStore& bodies) {
    push(a_, armOf(a_, bodies), -impulse_, bodies);
    push(b_, armOf(b_, bodies), impulse_, bodies);
    if (torque_ > 0) turn(bodies, turnImpulse_);
}

/// wanted: what the hinge is to undo.
void RevoluteJoint::drive(BodyStore& bodies, const Masses& masses, const Vec2f& wanted, float step) {
    const float freedom = masses.inverseInertia - masses.u.dot(masses.solve(masses.u));
    if (!(freedom > held * masses.inverseInertia)) return;
    const float turning = bodies.velocity[b_.body].w * b_.rho - bodies.velocity[a_.body].w * a_.rho;
    const float change = (speed_ - turning + masses.u.dot(masses.solve(wanted))) / freedom;
    const float limit = torque_ * (0.5f * step);
    const float now = std::clamp(turnImpulse_ + change, -limit, limit);
    turn(bodies, now - turnImpulse_);
    turnImpulse_ = now;
    totalTurn_ += now;
}

void RevoluteJoint::solve(BodyStore& bodies, const JointPass& pass) {
    const Vec2f ra = armOf(a_, bodies);
    const Vec2f rb = armOf(b_, bodies);
    const Masses masses = massesOf(bodies, ra, rb);
    Vec2f aside(0, 0);
    float massScale = 1;
    float impulseScale = 0;
    if (pass.correct) {
        const Softness& soft = alone_ ? pass.rigid : pass.soft;
        const Vec2f gap = startGap_ + (travelOf(b_, rb, bodies) - travelOf(a_, ra, bodies));
        const Vec2f bend = bendOf(b_, rb, pass.step, bodies) - bendOf(a_, ra, pass.step, bodies);
        const float rate = std::min(soft.biasRate, pass.pullSpeed / std::max(gap.norm(), 1e-9f));
        aside = gap * rate - bend;
        massScale = soft.massScale;
        impulseScale = soft.impulseScale;
    }
    const auto wanted = [&]() -> Vec2f { return (velocityAt(b_, rb, bodies) - velocityAt(a_, ra, bodies)) + aside; };
    if (torque_ > 0) drive(bodies, masses, wanted(), pass.step);
    const Vec2f change = -masses.solve(wanted()) * massScale - impulse_ * impulseScale;
    impulse_ += change;
    total_ += impulse_;
    push(a_, ra, -change, bodies);
    push(b_, rb, change, bodies);
}

}  // namespace plumb
