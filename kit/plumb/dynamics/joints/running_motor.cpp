// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/running_motor.h>

namespace plumb {

namespace {

bool doesActuatorRun(const MotorJoint& joint, const Ends& now, double enough) {
    const MotorJointDef& def = joint.def();
    const Vec2 fromA = now.a.arm + now.apart();
    const Vec2 speed = (now.b.velocity + perp(now.b.arm) * now.b.spin) - (now.a.velocity + perp(fromA) * now.a.spin);
    const Vec2 wanted = now.a.rotation * def.velocity;
    const double along = wanted.stableNormalized().dot(speed);
    return (def.maxForce > 0 && follows(along, wanted.norm(), enough)) ||
           (def.maxTorque > 0 && follows(now.b.spin - now.a.spin, def.angularVelocity, enough));
}

}  // namespace

bool isMotorRunning(const JointStore& joints, const BodyStore& bodies, JointIndex index, double enough) {
    return std::visit(
        [&]<class Joint>(const Joint& joint) {
            if constexpr (std::is_same_v<Joint, MotorJoint>) {
                return doesActuatorRun(joint, endsAtRest(joint.anchors, bodies), enough);
            } else if constexpr (requires { joint.def().maxMotorTorque; }) {
                const Ends now = endsAtRest(joint.anchors, bodies);
                return joint.def().maxMotorTorque > 0 &&
                       follows(now.b.spin - now.a.spin, joint.def().motorSpeed, enough);
            } else if constexpr (requires { joint.def().maxMotorForce; }) {
                return joint.def().maxMotorForce > 0 &&
                       follows(joints.speedOf(index, bodies), joint.def().motorSpeed, enough);
            } else {
                return false;
            }
        },
        joints[index].joint);
}

}  // namespace plumb
