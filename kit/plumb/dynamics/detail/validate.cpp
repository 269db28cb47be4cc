// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/validate.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/dynamics/detail/body_shapes.h>
#include <plumb/math/check.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

/// Farther from its body's origin than this, a shape's corners are too coarse in the solver's floats to touch anything.
constexpr double farthestCorner = 1e5;

void validateBodies(const WorldState& world, BodyId a, BodyId b, const std::string& def) {
    requireBody(world, a, def + ".bodyA");
    requireBody(world, b, def + ".bodyB");
    if (a == b) refuse(def + ".bodyB", "is the same body as bodyA, two were wanted");
    if (!world.bodies.isDynamic(a.index) && !world.bodies.isDynamic(b.index))
        refuse(def + ".bodyB", "neither it nor bodyA is dynamic, so the joint could move nothing");
}

/// An arm longer than this is too coarse in the solver's floats.
void requireNear(const WorldState& world, BodyId body, const Vec2& anchor, const std::string& field) {
    constexpr double longest = 1e5;
    if ((anchor - world.bodies.motion[body.index].center).norm() <= longest) return;
    refuse(field, toText(anchor) + " is more than " + toText(longest) + " m from the body it is on");
}

void validateJoint(const WorldState& world, const RevoluteJointDef& def) {
    validateBodies(world, def.bodyA, def.bodyB, "RevoluteJointDef");
    requireFinite(def.anchor, "RevoluteJointDef.anchor");
    requireNear(world, def.bodyA, def.anchor, "RevoluteJointDef.anchor");
    requireNear(world, def.bodyB, def.anchor, "RevoluteJointDef.anchor");
    requireFinite(def.motorSpeed, "RevoluteJointDef.motorSpeed");
    if (def.maxMotorTorque != std::numeric_limits<double>::infinity())
        requireNotNegative(def.maxMotorTorque, "RevoluteJointDef.maxMotorTorque");
}

void validateJoint(const WorldState& world, const DistanceJointDef& def) {
    validateBodies(world, def.bodyA, def.bodyB, "DistanceJointDef");
    requireFinite(def.anchorA, "DistanceJointDef.anchorA");
    requireFinite(def.anchorB, "DistanceJointDef.anchorB");
    if (def.anchorA == def.anchorB)
        refuse("DistanceJointDef.anchorB", toText(def.anchorB) + " is anchorA too, so the rod would have no direction");
    requireNear(world, def.bodyA, def.anchorA, "DistanceJointDef.anchorA");
    requireNear(world, def.bodyB, def.anchorB, "DistanceJointDef.anchorB");
    if (def.length) requirePositive(*def.length, "DistanceJointDef.length");
}

template <class Def>
void validateJoint(const WorldState&, const Def&) {
    refuse("JointDef", "not made yet");
}

template <class Id>
std::string textOf(const Id& id) {
    return "{index " + std::to_string(id.index) + ", generation " + std::to_string(id.generation) + ", world " +
           std::to_string(id.world) + "}";
}

/// Says which way an id is wrong.
template <class Id>
[[noreturn]] void refuseId(const WorldState& world, const Id& id, std::string_view field, const char* thing) {
    const std::string what = textOf(id);
    if (id.world == 0) refuse(field, what + " names no " + thing + ": it was never set");
    if (id.world != world.id) refuse(field, what + " belongs to another world");
    refuse(field, what + " names no " + thing + " of this world any more: it was removed");
}

}  // namespace

void validate(const WorldDef& def) {
    requireFinite(def.gravity, "WorldDef.gravity");
    if (def.hitSpeed != std::numeric_limits<double>::infinity()) requireNotNegative(def.hitSpeed, "WorldDef.hitSpeed");
    const SolverSettings& s = def.solver;
    requireWithin(s.subSteps, 1, 64, "WorldDef.solver.subSteps");
    requirePositive(s.contactFrequency, "WorldDef.solver.contactFrequency");
    requirePositive(s.contactDampingRatio, "WorldDef.solver.contactDampingRatio");
    requirePositive(s.contactPushSpeed, "WorldDef.solver.contactPushSpeed");
    requireNotNegative(s.sleepSpeed, "WorldDef.solver.sleepSpeed");
    requireNotNegative(s.sleepTime, "WorldDef.solver.sleepTime");
    if (s.lanes != 1 && s.lanes != 4 && s.lanes != 8 && s.lanes != 16)
        refuse("WorldDef.solver.lanes", std::to_string(s.lanes) + " is not 1, 4, 8 or 16");
}

void validate(const WorldState& world, const JointDef& def) {
    std::visit([&world](const auto& d) { validateJoint(world, d); }, def);
}

void requireMass(const Mass& mass, const std::string& field, const std::string& why) {
    const std::string hint = why.empty() ? why : " (" + why + ")";
    if (why.empty()) requireFinite(mass.center, field, ".center");
    if (!(mass.mass > 0) || !std::isfinite(mass.mass))
        refuse(field + ".mass", toText(mass.mass) + " is not a positive finite mass" + hint);
    if (!(mass.inertia > 0) || !std::isfinite(mass.inertia))
        refuse(field + ".inertia", toText(mass.inertia) + " is not a positive finite moment of inertia" + hint);
    // The solver's floats hold the squares and products of what is within these.
    requireWithin(mass.mass, 1e-12, 1e12, field, ".mass");
    requireWithin(std::sqrt(mass.inertia / mass.mass), 1e-6, 1e6, field, ".inertia, its radius of gyration");
}

void requireShape(const ShapeDef& def, const std::string& field) {
    validate(def, field);
    const Aabb box = aabbOf(def.shape, {});
    const double reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    if (reach > farthestCorner)
        refuse(field + ".shape", toText(reach) + " m from the body's origin, at most " + toText(farthestCorner) +
                                     " m was wanted: place the body there instead, or use several");
}

bool isKnown(const WorldState& world, ShapeId id) {
    return isKnown(world, id.body) && !piecesOf(world, id.body.index, id.number).empty();
}

bool isKnown(const WorldState& world, BodyId id) {
    const auto& records = world.bodies.record;
    return id.world == world.id && id.index < records.size() && records[id.index].alive &&
           records[id.index].generation == id.generation;
}

bool isKnown(const WorldState& world, JointId id) {
    const auto& joints = world.joints;
    return id.world == world.id && id.index < joints.size() && joints[id.index].generation == id.generation &&
           !std::holds_alternative<std::monostate>(joints[id.index].joint);
}

void requireBody(const WorldState& world, BodyId id, std::string_view field) {
    if (!isKnown(world, id)) refuseId(world, id, field, "body");
}

void requireShape(const WorldState& world, ShapeId id, std::string_view field) {
    const std::string name(field);
    requireBody(world, id.body, name + ".body");
    if (!isKnown(world, id))
        refuse(name + ".number",
               std::to_string(id.number) + " names no shape of that body: it was removed, or never was");
}

void requireJoint(const WorldState& world, JointId id, std::string_view field) {
    if (!isKnown(world, id)) refuseId(world, id, field, "joint");
}

}  // namespace plumb
