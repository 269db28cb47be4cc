// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/validate.h>

#include <limits>
#include <string>

#include <plumb/math/check.h>

namespace plumb {

namespace {

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

bool isKnown(const WorldState& world, BodyId id) {
    const auto& records = world.bodies.record;
    return id.world == world.id && id.index < records.size() && records[id.index].alive &&
           records[id.index].generation == id.generation;
}

bool isKnown(const WorldState& world, JointId id) {
    const auto& joints = world.joints.records;
    return id.world == world.id && id.index < joints.size() && joints[id.index].generation == id.generation &&
           !joints[id.index].isFree() && !joints[id.index].isHidden();
}

void requireBody(const WorldState& world, BodyId id, std::string_view field) {
    if (!isKnown(world, id)) refuseId(world, id, field, "body");
}

void requireJoint(const WorldState& world, JointId id, std::string_view field) {
    if (!isKnown(world, id)) refuseId(world, id, field, "joint");
}

}  // namespace plumb
