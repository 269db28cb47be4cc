// SPDX-License-Identifier: MIT
// How do two bodies share a point, and how does a motor turn them about it?
//
// Solve leaves the anchors together after the coming sub-step, not only moving together now: to second order in h
//   C + h (vB - vA) - h^2/2 (wB^2 rB - wA^2 rA) = 0
// C gap between the anchors [m], v their velocities [m/s], w angular velocities [rad/s], r arms [m], h sub-step [s].
// Relax then makes the velocities agree at the new place. Together with gravity in two halves this is RATTLE, of second
// order and without drift of the energy.
// Source: Andersen, "Rattle", J. Comput. Phys. 52 (1983) 24.
// Test: "a pendulum's error falls as the square of the step"
//
// A motor gives each half sub-step an angular impulse L, on B, back on A, of at most its torque times h/2:
//   L = (s - w + u.K^-1 g) / (1/IA + 1/IB - u.K^-1 u)
// s speed wanted, w = wB - wA [rad/s], g what the hinge is to undo of the anchors' relative velocity [m/s], K what an
// impulse at the hinge does to that [1/kg], u what an angular impulse does to it [1/(kg m)].
// Source: both constraints as one system, the hinge eliminated: so that one solve turns even what hangs off its centre.
// Test: "a motor of 2 N m spins a disc of 0.5 kg m^2 up at 4 rad/s^2 to its speed, then gives no more torque"
#pragma once
#include <plumb/dynamics/detail/anchor.h>
#include <plumb/dynamics/detail/softness.h>
#include <plumb/dynamics/joint_def.h>

namespace plumb {

/// What every joint's solve is told.
struct JointPass {
    float step = 0;       ///< h [s]
    bool correct = true;  ///< solve: with the position error; relax: without
    float pullSpeed = 0;  ///< the fastest that a gap is closed [m/s]
    Softness rigid;       ///< for a joint that is alone on its bodies, and so is solved at once
    Softness soft;        ///< for joints that share a body
};

class RevoluteJoint {
public:
    RevoluteJoint(const RevoluteJointDef& def, const BodyStore& bodies);

    void prepare(const BodyStore& bodies, bool alone);
    void warmStart(BodyStore& bodies);
    void solve(BodyStore& bodies, const JointPass& pass);
    Vec2f reaction() const { return total_; }             ///< impulse on B over the last step [N s]
    float angularReaction() const { return totalTurn_; }  ///< the motor's, on B, over the last step [N m s]

private:
    struct Masses;

    Masses massesOf(const BodyStore& bodies, const Vec2f& ra, const Vec2f& rb) const;
    void drive(BodyStore& bodies, const Masses& masses, const Vec2f& wanted, float step);
    void turn(BodyStore& bodies, float impulse) const;

    Anchor a_, b_;
    bool alone_ = false;
    Vec2f startGap_{0, 0};
    Vec2f impulse_{0, 0};
    Vec2f total_{0, 0};
    float speed_ = 0, torque_ = 0;  ///< what the motor is to reach [rad/s], and may use [N m]; 0: no motor
    float turnImpulse_ = 0;         ///< of half a sub-step [N m s]
    float totalTurn_ = 0;
};

}  // namespace plumb
