// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_store.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace plumb {

namespace {

template <class Joint>
constexpr bool hasEnds = requires(const Joint& joint) {
    joint.anchors;
};

/// A body that a call has put out of range keeps its numbers until the next step. What follows from them may be too
/// large for a double, or a difference of two such numbers.
double boundedNumber(double value) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::isnan(value) ? most : std::clamp(value, -most, most);
}

/// within: within a step, after the sub-steps done so far; else after the last step.
Ends endsOf(const AnchorPair& anchors, const BodyStore& bodies, bool within) {
    return within ? endsNow(anchors, bodies) : endsAtRest(anchors, bodies);
}

Geared geared(const JointStore& joints, JointIndex index, const BodyStore& bodies, double ahead, bool within) {
    Geared result;
    std::visit(
        [&]<class Joint>(const Joint& joint) {
            if constexpr (hasEnds<Joint>) {
                const Ends now = endsOf(joint.anchors, bodies, within);
                result.body = {now.a.body, now.b.body};
                result.row = joint.coordinateRow(now);
                result.speed = speedAhead(result.row, now, ahead);
                result.predicted = {joint.coordinate(now), joint.coordinate(after(now, ahead))};
            }
        },
        joints[index].joint);
    return result;
}

/// The error of a joint with two ends; 0 for others.
double anchorError(const AnyJoint& any, const BodyStore& bodies) {
    return std::visit(
        [&]<class Joint>(const Joint& joint) -> double {
            if constexpr (hasEnds<Joint>)
                return joint.error(endsAtRest(joint.anchors, bodies));
            else
                return 0;
        },
        any);
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

void JointStore::addRows(JointIndex index, const BodyStore& bodies, JointPass pass, JointRows& rows) const {
    pass.springShare = records[index].springShare;
    std::visit(
        [&]<class Joint>(const Joint& joint) {
            if constexpr (hasEnds<Joint>) {
                const Ends now = endsNow(joint.anchors, bodies);
                start(rows, now);
                joint.addRows(rows, now, pass);
            } else if constexpr (std::is_same_v<Joint, GearJoint>) {
                start(rows, {});
                joint.addRows(rows, geared(*this, joint.jointA, bodies, pass.step, true),
                              geared(*this, joint.jointB, bodies, pass.step, true), pass);
            } else {
                start(rows, {});
            }
        },
        records[index].joint);
}

JointForm JointStore::formOf(JointIndex index) const {
    return std::visit(
        [&]<class Joint>(const Joint& joint) {
            if constexpr (std::is_same_v<Joint, GearJoint>)
                return joint.form(coordinateFormOf(joint.jointA), coordinateFormOf(joint.jointB));
            else if constexpr (requires { joint.form(); })
                return joint.form();
            else
                return JointForm(AnchorPair{});
        },
        records[index].joint);
}

JointForm JointStore::coordinateFormOf(JointIndex index) const {
    if (const auto* slide = std::get_if<PrismaticJoint>(&records[index].joint)) return slide->coordinateForm();
    return std::get<RevoluteJoint>(records[index].joint).coordinateForm();
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
    return std::visit(
        []<class Joint>(const Joint& joint) {
            bool has = std::is_same_v<Joint, TargetJoint>;
            if constexpr (requires { joint.def().spring.has_value(); }) has = has || joint.def().spring.has_value();
            if constexpr (requires { joint.def().bending; }) has = has || joint.def().bending.has_value();
            return has;
        },
        records[index].joint);
}

SpringLoad JointStore::springLoadOf(JointIndex index, const BodyStore& bodies) const {
    return std::visit(
        [&]<class Joint>(const Joint& joint) -> SpringLoad {
            if constexpr (requires(const Ends& ends) { joint.springLoad(ends); })
                return joint.springLoad(endsAtRest(joint.anchors, bodies));
            else
                return {};
        },
        records[index].joint);
}

double JointStore::coordinateOf(JointIndex index, const BodyStore& bodies) const {
    if (const auto* gear = std::get_if<GearJoint>(&records[index].joint))
        return boundedNumber(coordinateOf(gear->jointA, bodies) + gear->ratio() * coordinateOf(gear->jointB, bodies));
    return boundedNumber(geared(*this, index, bodies, 0, false).predicted.now);
}

double JointStore::speedOf(JointIndex index, const BodyStore& bodies) const {
    if (const auto* gear = std::get_if<GearJoint>(&records[index].joint))
        return boundedNumber(speedOf(gear->jointA, bodies) + gear->ratio() * speedOf(gear->jointB, bodies));
    return boundedNumber(geared(*this, index, bodies, 0, false).speed);
}

double JointStore::errorOf(JointIndex index, const BodyStore& bodies) const {
    if (const auto* gear = std::get_if<GearJoint>(&records[index].joint))
        return boundedNumber(std::abs(coordinateOf(index, bodies) - gear->total()));
    return boundedNumber(anchorError(records[index].joint, bodies));
}

double JointStore::angleErrorOf(JointIndex index, const BodyStore& bodies) const {
    const double error = std::visit(
        [&]<class Joint>(const Joint& joint) -> double {
            if constexpr (requires(const Ends& ends) { joint.angleError(ends); })
                return joint.angleError(endsAtRest(joint.anchors, bodies));
            else
                return 0;
        },
        records[index].joint);
    return boundedNumber(error);
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

}  // namespace plumb
