// SPDX-License-Identifier: MIT
#include <compare/scene/validate/parts.h>

#include <algorithm>
#include <span>

#include <compare/scene/fields.h>
#include <compare/scene/named.h>

namespace plumb::compare {
namespace {

void requireNone(const std::string& name, const std::string& field, const std::string& why) {
    if (!name.empty()) refuse(field, quoted(name) + " is one too many: " + why);
}

void requireBody(const Scene& scene, const std::string& name, const NameIndex& bodies, const std::string& field) {
    if (!bodies.find(name)) requireKnown(name, namesOf(scene.bodies), field, "a body");
}

/// The joint that a gear couples must come before the gear, and must turn or slide.
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

/// Not every engine accepts a distance joint of length 0.
void requireLength(const JointDef& def, const std::string& field) {
    const auto* distance = std::get_if<DistanceJointDef>(&def);
    if (distance != nullptr && !distance->length && distance->anchorA == distance->anchorB)
        refuse(field + ".anchorB", toText(distance->anchorB) + " is anchorA too, wanted another point or a length");
}

}  // namespace

void validateJoint(const Scene& scene, std::size_t index, const NameIndex& bodies) {
    const std::string field = at("joints", index);
    validateEnds(scene, index, bodies, field);
    const JointDef& def = scene.joints[index].def;
    const std::string defField = field + "." + tagsOfAlternatives<JointDef>[def.index()];
    requireLength(def, defField);
    plumb::validate(def, defField);
}

}  // namespace plumb::compare
