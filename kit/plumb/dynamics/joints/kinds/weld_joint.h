// SPDX-License-Identifier: MIT
// How are two bodies held together as one?
//
// Three rows, for the gap along x and y and for the angle. A row with a spring is elastic instead of held.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class WeldJoint {
public:
    AnchorPair anchors;

    WeldJoint(const WeldJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, def.anchor, bodies), anchorAt(def.bodyB.index, def.anchor, bodies)},
          def_(def),
          reference_(bodies.motion[anchors.b.body].angle - bodies.motion[anchors.a.body].angle) {}

    const WeldJointDef& def() const { return def_; }
    void set(const WeldJointDef& def) { def_ = def; }
    JointForm form() const {
        JointForm form(anchors);
        form.measured = {.axis = RowAxis::Turning, .origin = reference_};
        if (!def_.spring) form.holdPoint();
        for (const int axis : {0, 1})
            if (def_.spring) form.addFree(RowAxis::World, Vec2::Unit(axis)).spring = *def_.spring;
        if (def_.bending) {
            RowForm& turning = form.addFree(RowAxis::Turning);
            turning.origin = reference_;
            turning.spring = *def_.bending;
        } else {
            form.add(RowAxis::Turning).origin = reference_;
        }
        return form;
    }

private:
    WeldJointDef def_;
    double reference_ = 0;  ///< B's angle less A's when the joint was made [rad]
};

}  // namespace plumb
