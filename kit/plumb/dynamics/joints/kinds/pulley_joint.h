// SPDX-License-Identifier: MIT
// How do two bodies hang on one rope over two fixed wheels?
//
// One row: the rate of lengthA + ratio lengthB. This sum may not exceed the length of the rope; the joint pulls and
// never pushes.
#pragma once
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

class PulleyJoint {
public:
    AnchorPair anchors;

    PulleyJoint(const PulleyJointDef& def, const BodyStore& bodies)
        : anchors{anchorAt(def.bodyA.index, bodies.near(def.anchorA, def.groundA), bodies),
                  anchorAt(def.bodyB.index, bodies.near(def.anchorB, def.groundB), bodies)},
          startA_((bodies.near(def.anchorA, def.groundA) - def.groundA).norm()),
          startB_((bodies.near(def.anchorB, def.groundB) - def.groundB).norm()) {
        set(def);
    }

    const PulleyJointDef& def() const { return def_; }
    void set(const PulleyJointDef& def) {
        def_ = def;
        length_ = startA_ + def.ratio * startB_;
    }
    JointForm form() const {
        JointForm form({{def_.groundA, noBody, {0, 0}}, anchors.a});
        form.links = 2;
        form.link[1] = {{def_.groundB, noBody, {0, 0}}, anchors.b};
        form.secondAxis = RowAxis::Along;
        form.ratio = def_.ratio;
        form.measured = form.addFree(RowAxis::Along);
        form.row[0].limit.upper = length_;
        return form;
    }

private:
    PulleyJointDef def_;
    double startA_ = 0, startB_ = 0;  ///< lengths when it was made [m]
    double length_ = 0;               ///< of the rope, B's part counted ratio times [m]
};

}  // namespace plumb
