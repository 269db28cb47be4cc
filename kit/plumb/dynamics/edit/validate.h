// SPDX-License-Identifier: MIT
// What may come in through the world's door?
#pragma once
#include <string>
#include <string_view>

#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// "{index 1, generation 0, world 2}"
std::string textOf(BodyId id);
std::string textOf(JointId id);

/// Does an id name a thing that is in this world now?
bool isKnown(const WorldState& world, BodyId id);
bool isKnown(const WorldState& world, JointId id);
bool isKnown(const WorldState& world, FieldId id);

bool isKnown(const WorldState& world, ShapeId id);

// Each throws std::invalid_argument naming the field, the value and what was wanted.
void validate(const WorldDef& def);
std::string nameOf(BodyType type);
std::string nameOf(const JointDef& def);  ///< "WeldJointDef"
void requireType(BodyType type, const std::string& field);
/// Of a dynamic body; why says what else could have been given.
void requireMass(const Mass& mass, const std::string& field, const std::string& why = {});
/// A shape that a body can have.
void requireShape(const ShapeDef& def, const std::string& field);
/// No shape may be wider than a world that wraps, nor higher, as it lies.
void requireFit(const WorldState& world, const Shape& shape, const Transform& pose, const std::string& field);
void requireFit(const WorldState& world, const BodyDef& def);
/// Nor may a question reach around the world more often than can be answered.
void requireFewRounds(const WorldState& world, const Aabb& box, double most, const std::string& field);
void validate(const WorldState& world, const JointDef& def);
/// And unless it is of the kind, the bodies, the anchors and the axes of what it is to replace.
void validateChange(const JointDef& from, const JointDef& to);
void requireBody(const WorldState& world, BodyId id, std::string_view field);
void requireShape(const WorldState& world, ShapeId id, std::string_view field);
void requireField(const WorldState& world, FieldId id, std::string_view field);
void validate(const WorldState& world, const FieldDef& def);
void requireJoint(const WorldState& world, JointId id, std::string_view field);

}  // namespace plumb
