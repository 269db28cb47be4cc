// SPDX-License-Identifier: MIT
// How is a body moved relative to another with bounded force?
//
// Three driven rows: along the missing velocity of B, across it, and turning.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class MotorJoint {
public:
    AnchorPair anchors;

    MotorJoint(const MotorJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, bodies.origin(def.bodyA.index), bodies),
                  anchorAt(def.bodyB.index, bodies.near(bodies.origin(def.bodyB.index), bodies.origin(def.bodyA.index)),
                           bodies)},
          startOffset_(bodies.motion[anchors.a.body].rotation.inverse() *
                       Vec2(bodies.near(bodies.origin(def.bodyB.index), bodies.origin(def.bodyA.index)) -
                            bodies.origin(def.bodyA.index))),
          startAngle_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {
        set(def);
    }

    const MotorJointDef& def() const { return def_; }
    void set(const MotorJointDef& def) {
        def_ = def;
        offset_ = def.offset.value_or(startOffset_);
        angle_ = def.angle.value_or(startAngle_);
    }
    JointForm form() const {
        AnchorPair ends = anchors;
        ends.a.local += offset_;
        JointForm form(ends);
        form.measured = {.axis = RowAxis::Along};
        if (def_.maxForce > 0) {
            // The first row lies along the missing velocity, so that the bound of the force is the same in every
            // direction.
            for (const RowAxis axis : {RowAxis::Missing, RowAxis::Beside}) {
                RowForm& row = form.addFree(axis, def_.velocity);
                row.maxForce = def_.maxForce;
                row.rate = def_.rate;
            }
        }
        if (def_.maxTorque > 0) {
            RowForm& turning = form.addFree(RowAxis::Turning);
            turning.origin = angle_;
            turning.speed = def_.angularVelocity;
            turning.maxForce = def_.maxTorque;
            turning.rate = def_.rate;
        }
        return form;
    }

private:
    MotorJointDef def_;
    Vec2 startOffset_{0, 0};
    double startAngle_ = 0;
    Vec2 offset_{0, 0};  ///< of B's origin from A's, in A's frame [m]
    double angle_ = 0;   ///< of B against A [rad]
};

}  // namespace plumb
