// SPDX-License-Identifier: MIT
#include <compare/metric/joint_state.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/observation.h>

namespace plumb::compare {
namespace {

template <class... Visits>
struct Overloaded : Visits... {
    using Visits::operator()...;
};
template <class... Visits>
Overloaded(Visits...) -> Overloaded<Visits...>;

double outside(double value, double lower, double upper) {
    return std::max({lower - value, value - upper, 0.0});
}

double outside(double value, const std::optional<Limit>& limit) {
    return limit ? outside(value, limit->lower, limit->upper) : 0;
}

double energyOf(const std::optional<Spring>& spring, double off) {
    return spring ? spring->stiffness * off * off / 2 : 0;
}

}  // namespace

JointStates::JointStates(const Scene& scene) : joints_(jointGeometries(scene)) {
    for (const SceneBody& body : scene.bodies) startAngles_.push_back(body.def.angle);
    for (const JointGeometry& joint : joints_) {
        const auto* target = std::get_if<TargetJointDef>(&joint.def);
        targetSprings_.push_back(target ? springOf(*target, scene.bodies[joint.bodyB].def) : Spring{});
    }
}

bool JointStates::isPresent(std::size_t index, std::span<const BodyState> states) const {
    return std::ranges::all_of(bodiesOf(joints_, index), [&](std::size_t body) { return states[body].present; });
}

bool JointStates::isKnown(std::size_t index, std::span<const BodyState> states) const {
    return std::ranges::all_of(bodiesOf(joints_, index), [&](std::size_t body) { return isFinite(states[body]); });
}

JointStates::Sides JointStates::sidesOf(const JointGeometry& joint, std::span<const BodyState> states) const {
    const auto pose = [](const BodyState& state) { return Transform{state.position, Rot::fromAngle(state.angle)}; };
    const BodyState& b = states[joint.bodyB];
    Sides sides;
    const Vec2 end = pose(b) * joint.localAnchorB;
    if (joint.bodyA == noBody) {  // a target, fixed in the world
        sides.apart = end - joint.localAnchorA;
        return sides;
    }
    const BodyState& a = states[joint.bodyA];
    sides.apart = pose(a).inverse() * end - joint.localAnchorA;
    sides.along = joint.localAxis.dot(sides.apart);
    sides.across = cross(joint.localAxis, sides.apart);
    sides.turned = (b.angle - startAngles_[joint.bodyB]) - (a.angle - startAngles_[joint.bodyA]);
    return sides;
}

double JointStates::coordinate(const JointGeometry& joint, std::span<const BodyState> states) const {
    const Sides sides = sidesOf(joint, states);
    return std::holds_alternative<PrismaticJointDef>(joint.def) ? sides.along : sides.turned;
}

double JointStates::ropeOf(const JointGeometry& joint, const PulleyJointDef& def,
                           std::span<const BodyState> states) const {
    const auto hang = [&](std::size_t body, const Vec2& anchor, const Vec2& ground) {
        const BodyState& state = states[body];
        return (Transform{state.position, Rot::fromAngle(state.angle)} * anchor - ground).norm();
    };
    return hang(joint.bodyA, joint.localAnchorA, def.groundA) +
           def.ratio * hang(joint.bodyB, joint.localAnchorB, def.groundB);
}

double JointStates::gap(std::size_t index, std::span<const BodyState> states) const {
    const JointGeometry& joint = joints_[index];
    const auto slide = [&](const auto& def) {
        const Sides sides = sidesOf(joint, states);
        return std::hypot(sides.across, outside(sides.along, def.limit));
    };
    const auto gear = [&](const GearJointDef& def) {
        const JointGeometry &a = joints_[joint.jointA], &b = joints_[joint.jointB];
        const double off = std::abs(coordinate(a, states) + def.ratio * coordinate(b, states));
        if (std::holds_alternative<PrismaticJointDef>(a.def)) return off;
        return std::holds_alternative<PrismaticJointDef>(b.def) ? off / std::abs(def.ratio) : 0;
    };
    const auto rod = [&](const DistanceJointDef& def) {
        const double apart = sidesOf(joint, states).apart.norm();
        return def.spring ? outside(apart, def.minLength, def.maxLength) : std::abs(apart - *joint.length);
    };
    const Overloaded visit{
        [&](const RevoluteJointDef&) { return sidesOf(joint, states).apart.norm(); },
        [&](const PrismaticJointDef& def) { return slide(def); },
        [&](const DistanceJointDef& def) { return rod(def); },
        [&](const WeldJointDef& def) { return def.spring ? 0 : sidesOf(joint, states).apart.norm(); },
        [&](const WheelJointDef& def) { return slide(def); },
        [&](const PulleyJointDef& def) { return std::max(ropeOf(joint, def, states) - *joint.length, 0.0); },
        [&](const GearJointDef& def) { return gear(def); },
        [](const MotorJointDef&) { return 0.0; },
        [](const TargetJointDef&) { return 0.0; },
        [](const FilterJointDef&) { return 0.0; },
    };
    return std::visit(visit, joint.def);
}

double JointStates::beyondLimit(std::size_t index, std::span<const BodyState> states) const {
    const JointGeometry& joint = joints_[index];
    const auto visit = [&](const auto& def) -> double {
        if constexpr (!requires { def.limit; })
            return 0;
        else if constexpr (requires { def.axis; })
            return outside(sidesOf(joint, states).along, def.limit);
        else
            return outside(sidesOf(joint, states).turned, def.limit);
    };
    return std::visit(visit, joint.def);
}

double JointStates::springEnergy(std::size_t index, std::span<const BodyState> states) const {
    const JointGeometry& joint = joints_[index];
    const auto axial = [&](const auto& def) {
        return def.spring ? energyOf(def.spring, sidesOf(joint, states).along - def.restShift) : 0;
    };
    const auto weld = [&](const WeldJointDef& def) {
        if (!def.spring && !def.bending) return 0.0;
        const Sides sides = sidesOf(joint, states);
        return energyOf(def.spring, sides.apart.norm()) + energyOf(def.bending, sides.turned);
    };
    const Overloaded visit{
        [&](const RevoluteJointDef& def) {
            return def.spring ? energyOf(def.spring, sidesOf(joint, states).turned - def.restAngle) : 0;
        },
        [&](const PrismaticJointDef& def) { return axial(def); },
        [&](const DistanceJointDef& def) {
            return def.spring ? energyOf(def.spring, sidesOf(joint, states).apart.norm() - *joint.length) : 0;
        },
        [&](const WeldJointDef& def) { return weld(def); },
        [&](const WheelJointDef& def) { return axial(def); },
        [&](const TargetJointDef&) { return energyOf(targetSprings_[index], sidesOf(joint, states).apart.norm()); },
        [](const auto&) { return 0.0; },
    };
    return std::visit(visit, joint.def);
}

}  // namespace plumb::compare
