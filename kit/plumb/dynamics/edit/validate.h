// SPDX-License-Identifier: MIT
// Which values may users give to a world?
#pragma once
#include <span>
#include <string>
#include <string_view>

#include <plumb/dynamics/state/world_state.h>

namespace plumb {

/// "{index 1, generation 0, world 2}"
std::string textOf(BodyId id);
std::string textOf(JointId id);

/// Does an id name an object that exists in this world now?
bool isKnown(const WorldState& world, BodyId id);
bool isKnown(const WorldState& world, JointId id);
bool isKnown(const WorldState& world, FieldId id);

bool isKnown(const WorldState& world, ShapeId id);

// Each of these throws std::invalid_argument that names the field, the value and what is allowed.
void validate(const WorldDef& def);
std::string nameOf(BodyType type);
std::string nameOf(const JointDef& def);  ///< "WeldJointDef"
void requireType(BodyType type, const std::string& field);
/// Checks the mass of a dynamic body. why: a hint for the message about what else could have been given.
void requireMass(const Mass& mass, const std::string& field, const std::string& why = {});
/// Checks that one of the shapes of a dynamic body is thick enough for contacts, unless they are lines or sensors.
void requireThickness(std::span<const ShapeDef> shapes, const std::string& field);
/// Checks that a body can have this shape.
void requireShape(const ShapeDef& def, const std::string& field);
/// Checks that a shape in its pose is not wider or higher than a world that wraps.
void requireFit(const WorldState& world, const Shape& shape, const Transform& pose, const std::string& field);
void requireFit(const WorldState& world, const BodyDef& def);
/// Checks that a query does not reach around the world more than most times.
void requireFewPeriods(const WorldState& world, const Aabb& box, double most, const std::string& field);
void validate(const WorldState& world, const JointDef& def);
/// Checks a new def for an existing joint: kind, bodies, anchors and axes must be the same as before.
void validateChange(const JointDef& from, const JointDef& to);
/// Checks that the motor of a joint has a torque or a force, if it has a speed.
void requireMotor(const JointDef& def);
void requireBody(const WorldState& world, BodyId id, std::string_view field);
void requireShape(const WorldState& world, ShapeId id, std::string_view field);
void requireField(const WorldState& world, FieldId id, std::string_view field);
void validate(const WorldState& world, const FieldDef& def);
void requireJoint(const WorldState& world, JointId id, std::string_view field);

}  // namespace plumb
