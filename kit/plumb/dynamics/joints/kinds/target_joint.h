// SPDX-License-Identifier: MIT
// How is a point of a body dragged to a point of the world?
//
// Two rows, along the line to the target and across it: a spring of bounded force between the two points.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class TargetJoint {
public:
    AnchorPair anchors;

    TargetJoint(const TargetJointDef& def, const BodyStore& bodies)
        : anchors{{}, anchorAt(def.body.index, def.anchor, bodies)} {
        set(def, bodies);
    }

    const TargetJointDef& def() const { return def_; }
    void set(const TargetJointDef& def, const BodyStore& bodies) {
        def_ = def;
        anchors.a.local = bodies.near(def.target, endAtRest(anchors.b, bodies).point);
        spring_ = def.spring.value_or(springOf(5, 0.7, bodies.record[def.body.index].mass));
    }
    JointForm form() const {
        JointForm form(anchors);
        form.measured = {.axis = RowAxis::Along};
        for (const RowAxis axis : {RowAxis::Towards, RowAxis::Across}) {
            RowForm& row = form.addFree(axis);
            row.spring = spring_;
            row.bounded = boundOf(def_.maxForce) < unlimited;
            if (row.bounded) row.maxForce = def_.maxForce;
        }
        return form;
    }

private:
    TargetJointDef def_;
    Spring spring_;
};

}  // namespace plumb
