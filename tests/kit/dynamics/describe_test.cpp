// SPDX-License-Identifier: MIT
// Are all definitions described, each with its members, in the units that their headers say?
#include <map>
#include <sstream>

#include <plumb/math/check.h>

#include "catch.h"
#include "house/arrows.h"
#include "house/declarations.h"
#include "kit/dynamics/described_leaves.h"

namespace plumb::test {

namespace {

/// What is said of each definition, and of those that are members of it.
struct Collect {
    Descriptions& all;
    std::string type;

    template <class T>
    void operator()(const Member& member, const T& value) const {
        all[type].push_back(member);
        nested(value);
    }
    template <class T>
    void nested(const T& value) const {
        if constexpr (isVariantType<T>) {
            forEachAlternative(std::type_identity<T>(), [&](const auto& kind) { nested(kind); });
        } else if constexpr (isOptionalType<T>) {
            nested(typename T::value_type{});
        } else if constexpr (std::is_same_v<T, std::vector<ShapeDef>>) {
            nested(ShapeDef{});
        } else if constexpr (Described<T>) {
            const std::string name = definitionName<T>.type;
            if (!all.contains(name)) describe(value, Collect{all, name});
        }
    }
};

/// But for those of movers, whose definitions are not described.
std::string allHeaders() {
    std::string text;
    for (const SourceFile& source : sourcesUnder(repository / "kit/plumb", repository / "kit"))
        if (isInstalled(source.path) && moduleOf(source.path) != "movers") text += source.text + '\n';
    return text;
}

/// Definitions and members that stand in the headers and are not described, or otherwise.
std::vector<std::string> notDescribed(const Declarations& declared, const Descriptions& described) {
    std::vector<std::string> faults;
    for (const auto& [name, fields] : declared.structs)
        if (name.ends_with("Def") && !described.contains(name)) faults.push_back(name + " is not described");
    for (const auto& [name, members] : described) {
        Names names;
        for (const Member& member : members) names.push_back(member.name);
        if (!declared.structs.contains(name) || declared.structs.at(name) != names)
            faults.push_back(name + " is described with other members than it has, or in another order");
    }
    return faults;
}

/// The comments of a struct's fields: on their own lines and those below, or, of those that have none, just above.
std::string commentOf(const std::string& header, const std::string& type, const std::string& field) {
    std::istringstream lines(header.substr(header.find("struct " + type + " {")));
    std::string above, comment;
    bool found = false;
    for (std::string line; std::getline(lines, line) && line != "};";) {
        const std::size_t at = line.find("//");
        const std::string code = line.substr(0, at), said = at == std::string::npos ? "" : line.substr(at);
        const bool blank = code.find_first_not_of(' ') == std::string::npos;
        if (found && !blank && comment.find('[') != std::string::npos) break;
        const bool names =
            code.find(" " + field + " ") != std::string::npos || code.find(" " + field + "{") != std::string::npos;
        if (names) comment = above;
        if (found || names) comment += said;
        found = found || names;
        above = blank ? above + said : "";
    }
    return comment;
}

std::vector<std::string> otherUnits(const std::string& headers, const Descriptions& described) {
    std::vector<std::string> faults;
    for (const auto& [type, members] : described)
        for (const Member& member : members) {
            const std::string unit = member.unit, said = "[" + unit + "]";
            if (!unit.empty() && unit != "-" && commentOf(headers, type, member.name).find(said) == std::string::npos)
                faults.push_back(type + "." + member.name + " is not said to be in " + said);
        }
    return faults;
}

/// Of what is allowed, in words; "" if that is anything.
std::string boundsOf(const Allowed& allowed) {
    std::string text = allowed.anything                             ? ""
                       : allowed.sign == Allowed::Sign::Positive    ? "> 0"
                       : allowed.sign == Allowed::Sign::NotNegative ? ">= 0"
                       : allowed.isRange()     ? toText(allowed.low) + " to " + toText(allowed.high)
                       : allowed.oneOf.empty() ? "any"
                                               : "one of";
    for (const int choice : allowed.oneOf) text += " " + std::to_string(choice);
    if (allowed.infinite) text += ", inf";
    if (allowed.minusInfinite) text += ", -inf";
    if (allowed.beyond != nullptr) text += ", up to " + toText(allowed.most);
    if (allowed.zero != nullptr) text += ", not 0";
    if (allowed.anchor != AnchorOf::None) text += ", anchor of " + std::to_string(static_cast<int>(allowed.anchor));
    return allowed.once ? text + ", once" : text;
}

/// Each member of each definition of which not anything is allowed.
const std::map<std::string, std::string> allBounds{
    {", once",
     " DistanceJointDef.bodyA DistanceJointDef.bodyB FilterJointDef.bodyA FilterJointDef.bodyB"
     " GearJointDef.jointA GearJointDef.jointB MotorJointDef.bodyA MotorJointDef.bodyB"
     " PrismaticJointDef.bodyA PrismaticJointDef.bodyB PulleyJointDef.bodyA PulleyJointDef.bodyB"
     " RevoluteJointDef.bodyA RevoluteJointDef.bodyB TargetJointDef.body WeldJointDef.bodyA"
     " WeldJointDef.bodyB WheelJointDef.bodyA WheelJointDef.bodyB"},
    {"0 to 1", " Material.restitution"},
    {"0.001 to 1000000000", " Wrap.width Wrap.height"},
    {"1 to 16777216", " TileMapDef.columns TileMapDef.rows"},
    {"1 to 64", " SolverSettings.subSteps"},
    {"1 to 8", " Attractor.power"},
    {"> 0",
     " Capsule.radius Circle.radius SolverSettings.contactFrequency SolverSettings.contactDampingRatio"
     " SolverSettings.contactPushSpeed TileMapDef.size"},
    {"> 0, inf", " Attractor.range Breaking.force Breaking.torque"},
    {"> 0, up to 1e+15", " DistanceJointDef.length PulleyJointDef.ratio"},
    {">= 0",
     " Attractor.softening BodyDef.linearDamping BodyDef.angularDamping DistanceJointDef.minLength"
     " Drag.linear Drag.quadratic Fluid.density GroundFriction.friction GroundFriction.gravity"
     " GroundFriction.lever Mass.mass Mass.inertia Material.density Material.friction"
     " Material.rollingResistance MutualGravity.constant MutualGravity.softening Polygon.radius Pool.drag"
     " SolverSettings.sleepSpeed SolverSettings.sleepTime Spring.stiffness Spring.damping"},
    {">= 0, inf",
     " DistanceJointDef.maxLength DistanceJointDef.maxMotorForce MotorJointDef.maxForce"
     " MotorJointDef.maxTorque PrismaticJointDef.maxMotorForce RevoluteJointDef.maxMotorTorque"
     " TargetJointDef.maxForce WheelJointDef.maxMotorTorque WorldDef.hitSpeed"},
    {">= 0, up to 1e+15", " MotorJointDef.rate"},
    {"any",
     " Attractor.center Attractor.strength BodyDef.position BodyDef.angle BodyDef.velocity"
     " BodyDef.angularVelocity BodyDef.gravityScale Capsule.start Capsule.end Chain.points Circle.center"
     " Drag.wind Fluid.surface Fluid.gravity Mass.center Material.surfaceSpeed Polygon.vertices Pool.flow"
     " Segment.start Segment.end Segment.before Segment.after UniformGravity.acceleration WorldDef.gravity"},
    {"any, -inf", " Limit.lower"},
    {"any, anchor of 1, once", " DistanceJointDef.anchorA PulleyJointDef.anchorA TargetJointDef.anchor"},
    {"any, anchor of 2, once", " DistanceJointDef.anchorB PulleyJointDef.anchorB"},
    {"any, anchor of 3, once",
     " PrismaticJointDef.anchor RevoluteJointDef.anchor WeldJointDef.anchor WheelJointDef.anchor"},
    {"any, inf", " Limit.upper"},
    {"any, not 0", " ShapeDef.oneWay"},
    {"any, not 0, once", " PrismaticJointDef.axis WheelJointDef.axis"},
    {"any, up to 1e+15",
     " DistanceJointDef.motorSpeed MotorJointDef.offset MotorJointDef.angle MotorJointDef.velocity"
     " MotorJointDef.angularVelocity PrismaticJointDef.restShift PrismaticJointDef.motorSpeed"
     " RevoluteJointDef.restAngle RevoluteJointDef.motorSpeed TargetJointDef.target WheelJointDef.restShift"
     " WheelJointDef.motorSpeed"},
    {"any, up to 1e+15, not 0", " GearJointDef.ratio"},
    {"any, up to 1e+15, once", " PulleyJointDef.groundA PulleyJointDef.groundB"},
    {"one of 1 4 8 16", " SolverSettings.lanes"},
};

using Faults = std::vector<std::string>;

}  // namespace

Descriptions allDescriptions() {
    Descriptions all;
    const Collect collect{all, ""};
    collect.nested(WorldDef{});
    collect.nested(BodyDef{});
    collect.nested(FieldDef{});
    collect.nested(TileMapDef{});
    collect.nested(JointDef{});
    return all;
}

TEST_CASE("each definition of the kit is described, with all of its members in their order", "[dynamics][describe]") {
    const Descriptions all = allDescriptions();
    CHECK(all.size() > 30);
    Declarations declared;
    addDeclarations(declared, allHeaders());
    CHECK(notDescribed(declared, all) == Faults{});
    for (const auto& [type, members] : all)
        for (const Member& member : members) CHECK(*member.meaning != 0);
}

TEST_CASE("each member is described in the unit that its header says", "[dynamics][describe]") {
    CHECK(otherUnits(allHeaders(), allDescriptions()) == Faults{});
}

TEST_CASE("each number of a definition is allowed what the kit has always allowed it", "[dynamics][describe]") {
    std::map<std::string, std::string> bounds;
    for (const auto& [type, members] : allDescriptions())
        for (const Member& member : members)
            if (const std::string text = boundsOf(member.allowed); !text.empty())
                bounds[text] += " " + type + "." + member.name;
    for (const auto& [text, names] : allBounds) CHECK(text + ":" + bounds[text] == text + ":" + names);
    CHECK(bounds.size() == allBounds.size());
}

TEST_CASE("a member, a definition or a unit that is described otherwise is caught", "[dynamics][describe]") {
    const std::string header =
        "struct BallDef {\n    double radius = 1;  ///< [m]\n    double weight = 2;  ///< of the ball,\n"
        "                        ///< all of it [kg]\n    /// above [s]\n    double time = 3;\n};\n";
    Declarations declared;
    addDeclarations(declared, header);
    const Member radius{"radius", "m"}, weight{"weight", "kg"}, time{"time", "s"};
    const Descriptions right{{"BallDef", {radius, weight, time}}};
    CHECK(notDescribed(declared, right) == Faults{});
    CHECK(otherUnits(header, right) == Faults{});
    CHECK(notDescribed(declared, {}).size() == 1);
    CHECK(notDescribed(declared, {{"BallDef", {radius, weight}}}).size() == 1);
    CHECK(notDescribed(declared, {{"BallDef", {weight, radius, time}}}).size() == 1);
    CHECK(otherUnits(header, {{"BallDef", {{"radius", "kg"}, {"weight", "m"}, {"time", "m"}}}}).size() == 3);
}

}  // namespace plumb::test
