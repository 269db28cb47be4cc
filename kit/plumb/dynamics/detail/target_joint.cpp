// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/target_joint.h>

namespace plumb {

TargetJoint::TargetJoint(const TargetJointDef& def, const BodyStore& bodies)
    : anchors{{}, anchorAt(def.body.index, def.anchor, bodies)} {
    set(def, bodies);
}

void TargetJoint::set(const TargetJointDef& def, const BodyStore& bodies) {
    def_ = def;
    anchors.a.local = def.target;
    spring_ = def.spring.value_or(springOf(5, 0.7, bodies.record[def.body.index].mass));
}

SpringRows TargetJoint::springs(const Ends& now) const {
    SpringRows springs = springsFor(now);
    addPointSpring(springs, now, spring_);
    springs.mostForce = def_.maxForce;
    return springs;
}

}  // namespace plumb
