// SPDX-License-Identifier: MIT
// How do two bodies share a point?
//
// Solve leaves the anchors together after the coming sub-step, not only moving together now: to second order in h
//   C + h (vB - vA) - h^2/2 (wB^2 rB - wA^2 rA) = 0
// C gap between the anchors [m], v their velocities [m/s], w angular velocities [rad/s], r arms [m], h sub-step [s].
// Relax then makes the velocities agree at the new place. Together with gravity in two halves this is RATTLE, of second
// order and without drift of the energy.
// Source: Andersen, "Rattle", J. Comput. Phys. 52 (1983) 24.
// Test: "a pendulum's error falls as the square of the step"
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
    Vec2f reaction() const { return total_; }  ///< impulse on B over the last step [N s]

private:
    Anchor a_, b_;
    bool alone_ = false;
    Vec2f startGap_{0, 0};
    Vec2f impulse_{0, 0};
    Vec2f total_{0, 0};
};

}  // namespace plumb
