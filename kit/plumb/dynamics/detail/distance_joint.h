// SPDX-License-Identifier: MIT
// How do two points keep their distance?
//
// Solve looks where the anchors would be after the coming sub-step, d' = d + h (vB - vA) - h^2/2 (wB^2 rB - wA^2 rA),
// and makes |d'| the length by an impulse along d; relax makes the velocity along d vanish (see revolute_joint.h).
// d from anchor A to anchor B [m], h sub-step [s].
#pragma once
#include <plumb/dynamics/detail/revolute_joint.h>

namespace plumb {

class DistanceJoint {
public:
    DistanceJoint(const DistanceJointDef& def, const BodyStore& bodies);

    void prepare(const BodyStore& bodies, bool alone);
    void warmStart(BodyStore& bodies);
    void solve(BodyStore& bodies, const JointPass& pass);
    Vec2f reaction() const { return total_; }     ///< impulse on B over the last step [N s]
    static float angularReaction() { return 0; }  ///< a rod turns nothing

private:
    Vec2f between(const Vec2f& ra, const Vec2f& rb, const BodyStore& bodies) const;

    Anchor a_, b_;
    bool alone_ = false;
    float length_ = 1;
    Vec2f start_{0, 0};  ///< from anchor A to anchor B at the step's start [m]
    float impulse_ = 0;
    Vec2f total_{0, 0};
};

}  // namespace plumb
