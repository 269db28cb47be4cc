// SPDX-License-Identifier: MIT
#include <compare/scene/validate_joint.h>

#include <algorithm>
#include <span>

#include <compare/scene/fields.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

/// Infinite is as much as it takes.
void requireBound(double value, const std::string& field, const std::string& member) {
    if (!(value >= 0)) refuse(field + member, toText(value) + " is negative or no number");
}

void requireAxis(const Vec2& axis, const std::string& field) {
    requireFinite(axis, field, ".axis");
    if (axis.norm() == 0) refuse(field + ".axis", toText(axis) + " has no direction");
}

void requireLimit(const std::optional<Limit>& limit, const std::string& field) {
    if (limit && !(limit->lower <= limit->upper))
        refuse(field + ".limit.upper", toText(limit->upper) + " is not at least lower, " + toText(limit->lower));
}

void requireSpring(const std::optional<Spring>& spring, const std::string& field) {
    if (!spring) return;
    requireNotNegative(spring->stiffness, field, ".stiffness");
    requireNotNegative(spring->damping, field, ".damping");
}

void requireBreaking(const Breaking& breaking, const std::string& field) {
    if (!(breaking.force > 0)) refuse(field + ".breaking.force", toText(breaking.force) + " is not positive");
    if (!(breaking.torque > 0)) refuse(field + ".breaking.torque", toText(breaking.torque) + " is not positive");
}

/// Two anchors, or one for both.
void requireAnchors(const auto& def, const std::string& field) {
    if constexpr (requires { def.anchor; }) {
        requireFinite(def.anchor, field, ".anchor");
    } else {
        requireFinite(def.anchorA, field, ".anchorA");
        requireFinite(def.anchorB, field, ".anchorB");
    }
}

void validateDef(const RevoluteJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    requireFinite(def.motorSpeed, field, ".motorSpeed");
    requireBound(def.maxMotorTorque, field, ".maxMotorTorque");
    requireLimit(def.limit, field);
    requireSpring(def.spring, field + ".spring");
    requireFinite(def.restAngle, field, ".restAngle");
}

void validateDef(const PrismaticJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    requireAxis(def.axis, field);
    requireFinite(def.motorSpeed, field, ".motorSpeed");
    requireBound(def.maxMotorForce, field, ".maxMotorForce");
    requireLimit(def.limit, field);
    requireSpring(def.spring, field + ".spring");
    requireFinite(def.restShift, field, ".restShift");
}

void validateDef(const DistanceJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    if (def.length) requirePositive(*def.length, field, ".length");
    if (!def.length && def.anchorA == def.anchorB)
        refuse(field + ".anchorB", toText(def.anchorB) + " is anchorA too, wanted another point or a length");
    requireSpring(def.spring, field + ".spring");
    requireNotNegative(def.minLength, field, ".minLength");
    if (!(def.maxLength >= def.minLength))
        refuse(field + ".maxLength", toText(def.maxLength) + " is not at least minLength, " + toText(def.minLength));
    requireFinite(def.motorSpeed, field, ".motorSpeed");
    requireBound(def.maxMotorForce, field, ".maxMotorForce");
}

void validateDef(const WeldJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    requireSpring(def.spring, field + ".spring");
    requireSpring(def.bending, field + ".bending");
}

void validateDef(const WheelJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    requireAxis(def.axis, field);
    requireFinite(def.motorSpeed, field, ".motorSpeed");
    requireBound(def.maxMotorTorque, field, ".maxMotorTorque");
    requireLimit(def.limit, field);
    requireSpring(def.spring, field + ".spring");
    requireFinite(def.restShift, field, ".restShift");
}

void validateDef(const PulleyJointDef& def, const std::string& field) {
    requireFinite(def.groundA, field, ".groundA");
    requireFinite(def.groundB, field, ".groundB");
    requireAnchors(def, field);
    requirePositive(def.ratio, field, ".ratio");
}

void validateDef(const GearJointDef& def, const std::string& field) {
    requireFinite(def.ratio, field, ".ratio");
    if (def.ratio == 0) refuse(field + ".ratio", "0 couples nothing");
}

void validateDef(const MotorJointDef& def, const std::string& field) {
    if (def.offset) requireFinite(*def.offset, field, ".offset");
    if (def.angle) requireFinite(*def.angle, field, ".angle");
    requireNotNegative(def.rate, field, ".rate");
    requireFinite(def.velocity, field, ".velocity");
    requireFinite(def.angularVelocity, field, ".angularVelocity");
    requireBound(def.maxForce, field, ".maxForce");
    requireBound(def.maxTorque, field, ".maxTorque");
}

void validateDef(const TargetJointDef& def, const std::string& field) {
    requireAnchors(def, field);
    requireFinite(def.target, field, ".target");
    requireSpring(def.spring, field + ".spring");
    requireBound(def.maxForce, field, ".maxForce");
}

void validateDef(const FilterJointDef&, const std::string&) {}

void requireNone(const std::string& name, const std::string& field, const std::string& why) {
    if (!name.empty()) refuse(field, quoted(name) + " is one too many: " + why);
}

void requireBody(const Scene& scene, const std::string& name, const NameIndex& bodies, const std::string& field) {
    if (!bodies.find(name)) requireKnown(name, namesOf(scene.bodies), field, "a body");
}

/// A gear's joint stands before it, and turns or slides.
void requireDriven(const Scene& scene, std::size_t gear, const std::string& name, const std::string& field) {
    const auto before = std::span(scene.joints).first(gear);
    std::vector<std::string> known;
    for (const SceneJoint& joint : before) known.push_back(joint.name);
    requireKnown(name, known, field, "a joint before it");
    const JointDef& def = std::ranges::find(before, name, &SceneJoint::name)->def;
    if (!std::holds_alternative<RevoluteJointDef>(def) && !std::holds_alternative<PrismaticJointDef>(def))
        refuse(field, quoted(name) + " is neither revolute nor prismatic");
}

void validateEnds(const Scene& scene, std::size_t index, const NameIndex& bodies, const std::string& field) {
    const SceneJoint& joint = scene.joints[index];
    if (std::holds_alternative<GearJointDef>(joint.def)) {
        requireNone(joint.bodyA, field + ".bodyA", "a gear couples two joints");
        requireNone(joint.bodyB, field + ".bodyB", "a gear couples two joints");
        requireDriven(scene, index, joint.jointA, field + ".jointA");
        requireDriven(scene, index, joint.jointB, field + ".jointB");
        if (joint.jointA == joint.jointB)
            refuse(field + ".jointB", quoted(joint.jointB) + " is jointA too, wanted another joint");
        return;
    }
    requireNone(joint.jointA, field + ".jointA", "only a gear couples joints");
    requireNone(joint.jointB, field + ".jointB", "only a gear couples joints");
    requireBody(scene, joint.bodyA, bodies, field + ".bodyA");
    if (std::holds_alternative<TargetJointDef>(joint.def))
        return requireNone(joint.bodyB, field + ".bodyB", "a target has one body");
    requireBody(scene, joint.bodyB, bodies, field + ".bodyB");
    if (joint.bodyA == joint.bodyB)
        refuse(field + ".bodyB", quoted(joint.bodyB) + " is bodyA too, wanted another body");
}

}  // namespace

void validateJoint(const Scene& scene, std::size_t index, const NameIndex& bodies) {
    const std::string field = at("joints", index);
    validateEnds(scene, index, bodies, field);
    const JointDef& def = scene.joints[index].def;
    const std::string defField = field + "." + jointTags.begin()[def.index()];
    const auto check = [&](const auto& d) {
        validateDef(d, defField);
        if constexpr (requires { d.breaking; }) requireBreaking(d.breaking, defField);
    };
    std::visit(check, def);
}

}  // namespace plumb::compare
