// SPDX-License-Identifier: MIT
// How are two points kept at a distance, by a rod or by a spring?
//
// One row, along the line from anchor to anchor. For a rod it is held; for a spring it has limits and a motor.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class DistanceJoint {
public:
    AnchorPair anchors;

    DistanceJoint(const DistanceJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, def.anchorA, bodies),
                  anchorAt(def.bodyB.index, bodies.near(def.anchorB, def.anchorA), bodies)},
          def_(def),
          apart_((bodies.near(def.anchorB, def.anchorA) - def.anchorA).norm()),
          length_(def.length.value_or(apart_)) {}

    const DistanceJointDef& def() const { return def_; }
    void set(const DistanceJointDef& def) {
        def_ = def;
        length_ = def.length.value_or(apart_);
    }
    JointForm form() const {
        JointForm form(anchors);
        form.measured = {.axis = RowAxis::Along};
        if (!def_.spring) {
            form.add(RowAxis::Along).origin = length_;
            return form;
        }
        RowForm& stretching = form.addFree(RowAxis::Along);
        stretching.speed = def_.motorSpeed;
        stretching.maxForce = def_.maxMotorForce;
        if (def_.minLength > 0 || def_.maxLength < unlimited) stretching.limit = {def_.minLength, def_.maxLength};
        stretching.spring = *def_.spring;
        stretching.springRest = length_;
        return form;
    }

private:
    DistanceJointDef def_;
    double apart_ = 1;  ///< distance of the anchors when the joint was made [m]
    double length_ = 1;
};

}  // namespace plumb
