// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_store.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <plumb/dynamics/joints/joint_measure.h>

namespace plumb {

namespace {

/// A body that a call has put out of range keeps its numbers until the next step. What follows from them may be too
/// large for a double, or a difference of two such numbers.
double boundedNumber(double value) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::isnan(value) ? most : std::clamp(value, -most, most);
}

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

JointIndex JointStore::acquire() {
    if (free.empty()) {
        records.emplace_back();
        loads.emplace_back();
        return static_cast<JointIndex>(records.size() - 1);
    }
    const JointIndex joint = free.back();
    free.pop_back();
    return joint;
}

void JointStore::release(JointIndex joint) {
    const std::uint32_t generation = records[joint].generation + 1;
    std::erase(gears, joint);
    records[joint] = {};
    loads[joint] = {};
    records[joint].generation = generation;
    free.push_back(joint);
}

void JointStore::noteEdit(JointIndex joint) {
    changed = true;
    records[joint].edited = true;
    for (const JointIndex gear : gears) records[gear].edited = true;  // its form is made of those of two joints
}

void JointStore::noteEdits(const std::vector<JointIndex>& joints) {
    for (const JointIndex joint : joints) noteEdit(joint);
}

JointForm JointStore::formOf(JointIndex index) const {
    return std::visit(
        [&]<class Joint>(const Joint& joint) {
            if constexpr (std::is_same_v<Joint, GearJoint>)
                return joint.form(formOf(joint.jointA), formOf(joint.jointB));
            else if constexpr (requires { joint.form(); })
                return joint.form();
            else
                return JointForm(AnchorPair{});
        },
        records[index].joint);
}

JointDef JointRecord::def() const {
    return std::visit(
        []<class Joint>(const Joint& any) -> JointDef {
            if constexpr (requires { any.def(); })
                return any.def();
            else
                return {};
        },
        joint);
}

bool JointStore::hasSpring(JointIndex index) const {
    return formOf(index).hasSpring();
}

double JointStore::coordinateOf(JointIndex index, const BodyStore& bodies) const {
    const JointForm form = formOf(index);
    return boundedNumber(measure(form, form.measured, bodies).coordinate);
}

double JointStore::speedOf(JointIndex index, const BodyStore& bodies) const {
    const JointForm form = formOf(index);
    return boundedNumber(measure(form, form.measured, bodies).speed);
}

double JointStore::errorOf(JointIndex index, const BodyStore& bodies) const {
    return boundedNumber(plumb::errorOf(formOf(index), bodies));
}

double JointStore::angleErrorOf(JointIndex index, const BodyStore& bodies) const {
    return boundedNumber(plumb::angleErrorOf(formOf(index), bodies));
}

AnyJoint makeJoint(const JointDef& def, const JointStore& joints, const BodyStore& bodies) {
    return std::visit(
        [&]<class Def>(const Def& d) -> AnyJoint {
            using Kind = typename KindOf<Def>::type;
            if constexpr (std::is_same_v<Kind, GearJoint>)
                return Kind(d, joints.coordinateOf(d.jointA.index, bodies),
                            joints.coordinateOf(d.jointB.index, bodies));
            else if constexpr (std::is_constructible_v<Kind, const Def&, const BodyStore&>)
                return Kind(d, bodies);
            else
                return Kind(d);
        },
        def);
}

void changeJoint(AnyJoint& joint, const JointDef& def, const JointStore& joints, const BodyStore& bodies) {
    std::visit(
        [&]<class Def>(const Def& d) {
            auto& kind = std::get<typename KindOf<Def>::type>(joint);
            if constexpr (std::is_same_v<Def, GearJointDef>)
                kind.set(d, joints.coordinateOf(d.jointA.index, bodies), joints.coordinateOf(d.jointB.index, bodies));
            else if constexpr (requires { kind.set(d, bodies); })
                kind.set(d, bodies);
            else
                kind.set(d);
        },
        def);
}

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
