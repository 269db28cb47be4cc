// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/validate.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/describe.h>
#include <plumb/dynamics/edit/shape_pieces.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

/// Largest distance of a shape's corner from its body's origin [m]: beyond it, the solver's floats have steps of 8 mm
/// and more, too coarse for contacts. Test: "shapes and anchors up to 1e5 m from their body, and masses of 1e-12 to
/// 1e12 kg, are allowed, and no more"
constexpr double farthestCorner = 1e5;

std::string textOf(std::uint32_t index, std::uint32_t generation, std::uint32_t world) {
    return "{index " + std::to_string(index) + ", generation " + std::to_string(generation) + ", world " +
           std::to_string(world) + "}";
}

std::string textOf(FieldId id) {
    return textOf(id.index, id.generation, id.world);
}

/// Throws with the reason why an id is wrong. made: whether an object with this slot and generation ever existed.
template <class Id>
[[noreturn]] void refuseId(const WorldState& world, const Id& id, bool made, std::string_view field,
                           const char* thing) {
    const std::string what = textOf(id);
    if (id.world == 0) refuse(field, what + " names no " + thing + ": it was never set");
    if (id.world != world.bodies.world) refuse(field, what + " belongs to another world");
    if (!made) refuse(field, what + " names no " + thing + " of this world: there never was such a one");
    refuse(field, what + " names no " + thing + " of this world any more: it was removed");
}

}  // namespace

std::string textOf(BodyId id) {
    return textOf(id.index, id.generation, id.world);
}

std::string textOf(JointId id) {
    return textOf(id.index, id.generation, id.world);
}

void validate(const WorldDef& def) {
    requireMembers(def, {definitionName<WorldDef>.type});
}

/// A wider shape would meet its own image at the seam.
void requireFit(const WorldState& world, const Shape& shape, const Transform& pose, const std::string& field) {
    const Wrap& wrap = world.bodies.wrap;
    if (!wrap.any()) return;
    constexpr double nearly = 1 + 1e-9;  // a shape exactly as wide as the world fits, in spite of rounding
    const Aabb box = aabbOf(shape, pose);
    const Vec2 size = box.upper - box.lower;
    if (wrap.width && size.x() > *wrap.width * nearly)
        refuse(field, toText(size.x()) + " m wide, more than the world's " + toText(*wrap.width) + " m");
    if (wrap.height && size.y() > *wrap.height * nearly)
        refuse(field, toText(size.y()) + " m high, more than the world's " + toText(*wrap.height) + " m");
}

void requireFit(const WorldState& world, const BodyDef& def) {
    if (!world.bodies.wrap.any()) return;
    const Transform pose{def.position, Rot::fromAngle(def.angle)};
    for (std::size_t i = 0; i < def.shapes.size(); ++i)
        requireFit(world, def.shapes[i].shape, pose, "BodyDef.shapes[" + std::to_string(i) + "]");
}

/// A query visits each image that it reaches, so its cost grows with the rounds.
void requireFewPeriods(const WorldState& world, const Aabb& box, double most, const std::string& field) {
    const Wrap& wrap = world.bodies.wrap;
    if (!wrap.any()) return;
    const Vec2 size = box.upper - box.lower;
    const auto require = [&](double reach, const std::optional<double>& round) {
        if (round && reach > most * *round)
            refuse(field, toText(reach) + " m is more than " + toText(most) + " times around the world of " +
                              toText(*round) + " m");
    };
    require(size.x(), wrap.width);
    require(size.y(), wrap.height);
}

std::string nameOf(BodyType type) {
    return bodyTypeTags[static_cast<std::size_t>(type)];
}

void requireType(BodyType type, const std::string& field) {
    requireEnumerator(static_cast<int>(type), tagsOf(type), {field}, "");
}

/// A mass that follows from shapes cannot be mended by its own fields, so the message then tells what else to give
/// (why).
void requireMass(const Mass& mass, const std::string& field, const std::string& why) {
    const std::string hint = why.empty() ? why : " (" + why + ")";
    if (why.empty()) requireFinite(mass.center, field, ".center");
    if (!(mass.mass > 0) || !std::isfinite(mass.mass))
        refuse(field + ".mass", toText(mass.mass) + " is not a positive finite mass" + hint);
    if (!(mass.inertia > 0) || !std::isfinite(mass.inertia))
        refuse(field + ".inertia", toText(mass.inertia) + " is not a positive finite moment of inertia" + hint);
    const double off = mass.center.cwiseAbs().maxCoeff();
    if (why.empty() && off > farthestCorner)
        refuse(field + ".center",
               toText(mass.center) + " is more than " + toText(farthestCorner) + " m from the body's origin");
    // Within these bounds, squares and products stay in the range of the solver's floats.
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
    const Mass mass = massOf(def.shape, def.material.density);
    if (!std::isfinite(mass.mass) || !std::isfinite(mass.inertia))
        refuse(field + ".material.density", toText(def.material.density) + " makes a mass of " + toText(mass.mass) +
                                                " kg with a moment of inertia of " + toText(mass.inertia) +
                                                " kg m^2, finite ones were wanted");
}

bool isKnown(const WorldState& world, ShapeId id) {
    return isKnown(world, id.body) && !piecesOf(world, id.body.index, id.number).empty();
}

/// An id names one body for ever: its slot may get another body, but with a higher generation. Test: "an id of a
/// removed body is refused even after its slot was used again"
bool isKnown(const WorldState& world, BodyId id) {
    const auto& records = world.bodies.record;
    return id.world == world.bodies.world && id.index < records.size() && records[id.index].alive &&
           records[id.index].generation == id.generation;
}

bool isKnown(const WorldState& world, JointId id) {
    const auto& joints = world.joints.records;
    return id.world == world.bodies.world && id.index < joints.size() && joints[id.index].generation == id.generation &&
           !joints[id.index].isFree() && !joints[id.index].isHidden();
}

bool isKnown(const WorldState& world, FieldId id) {
    const auto& fields = world.fields.records;
    return id.world == world.bodies.world && id.index < fields.size() && fields[id.index].alive &&
           fields[id.index].generation == id.generation;
}

void requireField(const WorldState& world, FieldId id, std::string_view field) {
    if (isKnown(world, id)) return;
    const auto& fields = world.fields.records;
    const bool made = id.index < fields.size() && id.generation < fields[id.index].generation;
    refuseId(world, id, made, field, "field");
}

/// A generation that the slot has left behind was once a body: so the message can tell a removed body from one that
/// never was. Test: "an id that never was is not told that it was removed"
void requireBody(const WorldState& world, BodyId id, std::string_view field) {
    if (isKnown(world, id)) return;
    const auto& records = world.bodies.record;
    const bool made = id.index < records.size() && id.generation < records[id.index].generation;
    refuseId(world, id, made, field, "body");
}

/// A body counts the shapes that it ever had, and never uses a number again: so a removed one can be told from none.
void requireShape(const WorldState& world, ShapeId id, std::string_view field) {
    if (isKnown(world, id)) return;
    const std::string name(field);
    requireBody(world, id.body, name + ".body");
    const bool made = id.number < world.bodies.record[id.body.index].shapesMade;
    refuse(name + ".number",
           std::to_string(id.number) + (made ? " names no shape of that body any more: it was removed"
                                             : " names no shape of that body: there never was such a one"));
}

void requireJoint(const WorldState& world, JointId id, std::string_view field) {
    if (isKnown(world, id)) return;
    const auto& joints = world.joints.records;
    const bool made = id.index < joints.size() && id.generation < joints[id.index].generation;
    refuseId(world, id, made, field, "joint");
}

}  // namespace plumb
