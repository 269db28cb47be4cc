// SPDX-License-Identifier: MIT
// What are the members of a body's, joint's, field's or world's definition, and which values may they have?
#pragma once
#include <array>
#include <span>

#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/field_def.h>
#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/world_def.h>
#include <plumb/forces/describe_law.h>
#include <plumb/math/member.h>
#include <plumb/space/describe_shape_def.h>

namespace plumb {

// The names of the enumerators in a file, in their order.
inline constexpr std::array<const char*, 3> bodyTypeTags{"static", "kinematic", "dynamic"};
constexpr std::span<const char* const> tagsOf(BodyType) {
    return bodyTypeTags;
}

template <>
inline constexpr DefinitionName definitionName<BodyDef>{"BodyDef"};
void describe(OrConst<BodyDef> auto& def, auto&& visit) {
    visit({"type", "", Allowed::any, "what moves it"}, def.type);
    visit({"position", "m", Allowed::finite, "of the body's origin"}, def.position);
    visit({"angle", "rad", Allowed::finite, "of the body's frame"}, def.angle);
    visit({"velocity", "m/s", Allowed::finite, "of the centre of mass; zero for a static body"}, def.velocity);
    visit({"angularVelocity", "rad/s", Allowed::finite, "zero for a static body"}, def.angularVelocity);
    visit({"gravityScale", "-", Allowed::finite, "how many times the world's gravity it feels"}, def.gravityScale);
    visit({"linearDamping", "1/s", Allowed::notNegative, "its velocity decays as exp(-damping t)"}, def.linearDamping);
    visit({"angularDamping", "1/s", Allowed::notNegative, "its angular velocity decays likewise"}, def.angularDamping);
    visit({"fixedRotation", "", Allowed::any, "does nothing turn it?"}, def.fixedRotation);
    visit({"lockX", "", Allowed::any, "does a dynamic body stay where it is along x?"}, def.lockX);
    visit({"lockY", "", Allowed::any, "does a dynamic body stay where it is along y?"}, def.lockY);
    visit({"canSleep", "", Allowed::any, "may it fall asleep when it rests?"}, def.canSleep);
    visit({"awake", "", Allowed::any, "false: asleep until something touches it"}, def.awake);
    visit({"enabled", "", Allowed::any, "false: it stays where it is, and nothing meets it"}, def.enabled);
    visit({"tag", "", Allowed::any, "whatever its owner wants to know it by"}, def.tag);
    visit({"mass", "", Allowed::any, "instead of what the shapes and their densities give"}, def.mass);
    visit({"shapes", "", Allowed::any, "its outline"}, def.shapes);
}

/// For positions and velocities of bodies: beyond this bound a body would be put in quarantine.
constexpr Allowed withinReach(const Allowed& allowed) {
    return allowed.upTo(1e15, "where no body can be, nor move so fast");
}

/// The allowed values of a joint's members. Bodies, joints, anchors and axes can be given only once: changing them
/// would make another joint.
struct JointMembers {
    static constexpr Allowed id = Allowed::any.onlyOnce();
    static constexpr Allowed anchor = Allowed::finite.anchorOf(AnchorOf::Both);
    static constexpr Allowed anchorA = Allowed::finite.anchorOf(AnchorOf::First);
    static constexpr Allowed anchorB = Allowed::finite.anchorOf(AnchorOf::Second);
    static constexpr Allowed axis = Allowed::finite.butNotZero("has no direction").onlyOnce();
    static constexpr Allowed place = withinReach(Allowed::finite);
    static constexpr Allowed fixedPlace = place.onlyOnce();
    static constexpr Allowed strength = Allowed::notNegative.orInfinite();
    static constexpr Allowed load = Allowed::positive.orInfinite();
};

template <>
inline constexpr DefinitionName definitionName<Spring>{"Spring"};
void describe(OrConst<Spring> auto& def, auto&& visit) {
    visit({"stiffness", "N/m", Allowed::notNegative, "pull per stretch; of what turns [N m/rad]"}, def.stiffness);
    visit({"damping", "N s/m", Allowed::notNegative, "pull per speed; of what turns [N m s/rad]"}, def.damping);
}

template <>
inline constexpr DefinitionName definitionName<Limit>{"Limit"};
void describe(OrConst<Limit> auto& def, auto&& visit) {
    visit({"lower", "m", Allowed::finite.orMinusInfinite(), "no less than this; of what turns [rad]"}, def.lower);
    visit({"upper", "m", Allowed::finite.orInfinite(), "no more than this; of what turns [rad]"}, def.upper);
}

template <>
inline constexpr DefinitionName definitionName<Breaking>{"Breaking"};
void describe(OrConst<Breaking> auto& def, auto&& visit) {
    visit({"force", "N", JointMembers::load, "the most that it bears"}, def.force);
    visit({"torque", "N m", JointMembers::load, "the most that it bears"}, def.torque);
}

template <>
inline constexpr DefinitionName definitionName<RevoluteJointDef>{"RevoluteJointDef", "revolute"};
void describe(OrConst<RevoluteJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "one body"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the other body"}, def.bodyB);
    visit({"anchor", "m", JointMembers::anchor, "the hinge"}, def.anchor);
    visit({"limit", "", Allowed::any, "of B's angle against A's"}, def.limit);
    visit({"spring", "", Allowed::any, "turns B back to restAngle"}, def.spring);
    visit({"restAngle", "rad", JointMembers::place, "of B against A, from how they are turned now"}, def.restAngle);
    visit({"motorSpeed", "rad/s", JointMembers::place, "of B against A, that the motor is to reach"}, def.motorSpeed);
    visit({"maxMotorTorque", "N m", JointMembers::strength, "what the motor may use; 0: no motor"}, def.maxMotorTorque);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<PrismaticJointDef>{"PrismaticJointDef", "prismatic"};
void describe(OrConst<PrismaticJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "the body with the axis"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the body that slides"}, def.bodyB);
    visit({"anchor", "m", JointMembers::anchor, "where the force acts on both"}, def.anchor);
    visit({"axis", "-", JointMembers::axis, "fixed to A, of any length"}, def.axis);
    visit({"limit", "", Allowed::any, "of B's shift along the axis"}, def.limit);
    visit({"spring", "", Allowed::any, "pulls B back to restShift"}, def.spring);
    visit({"restShift", "m", JointMembers::place, "along the axis, from where they are now"}, def.restShift);
    visit({"motorSpeed", "m/s", JointMembers::place, "of B along the axis, that the motor is to reach"},
          def.motorSpeed);
    visit({"maxMotorForce", "N", JointMembers::strength, "what the motor may use; 0: no motor"}, def.maxMotorForce);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<DistanceJointDef>{"DistanceJointDef", "distance"};
void describe(OrConst<DistanceJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "one body"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the other body"}, def.bodyB);
    visit({"anchorA", "m", JointMembers::anchorA, "on bodyA"}, def.anchorA);
    visit({"anchorB", "m", JointMembers::anchorB, "on bodyB"}, def.anchorB);
    visit({"length", "m", withinReach(Allowed::positive), "without it, how far apart the anchors are now"}, def.length);
    visit({"spring", "", Allowed::any, "without it, a rod"}, def.spring);
    visit({"minLength", "m", Allowed::notNegative, "with a spring: no shorter than this"}, def.minLength);
    visit({"maxLength", "m", JointMembers::strength, "with a spring: no longer than this"}, def.maxLength);
    visit({"motorSpeed", "m/s", JointMembers::place, "with a spring: at which a motor is to lengthen it"},
          def.motorSpeed);
    visit({"maxMotorForce", "N", JointMembers::strength, "what the motor may use; 0: no motor"}, def.maxMotorForce);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<WeldJointDef>{"WeldJointDef", "weld"};
void describe(OrConst<WeldJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "one body"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the other body"}, def.bodyB);
    visit({"anchor", "m", JointMembers::anchor, "where the force acts on both"}, def.anchor);
    visit({"spring", "", Allowed::any, "of the anchor; without it, it is held rigidly"}, def.spring);
    visit({"bending", "", Allowed::any, "of the angle; without it, it is held rigidly"}, def.bending);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<WheelJointDef>{"WheelJointDef", "wheel"};
void describe(OrConst<WheelJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "the car"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the wheel"}, def.bodyB);
    visit({"anchor", "m", JointMembers::anchor, "the wheel's hub"}, def.anchor);
    visit({"axis", "-", JointMembers::axis, "of the suspension, fixed to A, of any length"}, def.axis);
    visit({"limit", "", Allowed::any, "of the hub's shift along the axis"}, def.limit);
    visit({"spring", "", Allowed::any, "pulls the hub back to restShift; without it, it slides freely"}, def.spring);
    visit({"restShift", "m", JointMembers::place, "along the axis, from where it is now"}, def.restShift);
    visit({"motorSpeed", "rad/s", JointMembers::place, "of B against A, that the motor is to reach"}, def.motorSpeed);
    visit({"maxMotorTorque", "N m", JointMembers::strength, "what the motor may use; 0: no motor"}, def.maxMotorTorque);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<PulleyJointDef>{"PulleyJointDef", "pulley"};
void describe(OrConst<PulleyJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "one body"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the other body"}, def.bodyB);
    visit({"groundA", "m", JointMembers::fixedPlace, "the wheel over bodyA, fixed in the world"}, def.groundA);
    visit({"groundB", "m", JointMembers::fixedPlace, "the wheel over bodyB"}, def.groundB);
    visit({"anchorA", "m", JointMembers::anchorA, "on bodyA"}, def.anchorA);
    visit({"anchorB", "m", JointMembers::anchorB, "on bodyB"}, def.anchorB);
    visit({"ratio", "-", withinReach(Allowed::positive), "A comes up by ratio times what B goes down"}, def.ratio);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<GearJointDef>{"GearJointDef", "gear"};
void describe(OrConst<GearJointDef> auto& def, auto&& visit) {
    visit({"jointA", "", JointMembers::id, "one joint, revolute or prismatic"}, def.jointA);
    visit({"jointB", "", JointMembers::id, "the other joint, revolute or prismatic"}, def.jointB);
    visit({"ratio", "-", JointMembers::place.butNotZero("would gear nothing"),
           "a + ratio b stays what it is; of two hinges, teeth of B over teeth of A; with a slide [m] or [1/m]"},
          def.ratio);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<MotorJointDef>{"MotorJointDef", "motor"};
void describe(OrConst<MotorJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "the body against which the pose is"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the body that is held"}, def.bodyB);
    visit({"offset", "m", JointMembers::place, "of B's origin in A's frame; without it, where it is now"}, def.offset);
    visit({"angle", "rad", JointMembers::place, "of B against A; without it, as it is now"}, def.angle);
    visit({"rate", "1/s", withinReach(Allowed::notNegative), "the share of its error that it takes back in a second"},
          def.rate);
    visit({"velocity", "m/s", JointMembers::place, "of B against A, in A's frame, beside that"}, def.velocity);
    visit({"angularVelocity", "rad/s", JointMembers::place, "of B against A, beside that"}, def.angularVelocity);
    visit({"maxForce", "N", JointMembers::strength, "what it may use"}, def.maxForce);
    visit({"maxTorque", "N m", JointMembers::strength, "what it may use"}, def.maxTorque);
    visit({"collideConnected", "", Allowed::any, "may the two bodies touch each other?"}, def.collideConnected);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<TargetJointDef>{"TargetJointDef", "target"};
void describe(OrConst<TargetJointDef> auto& def, auto&& visit) {
    visit({"body", "", JointMembers::id, "the body that is dragged"}, def.body);
    visit({"anchor", "m", JointMembers::anchorA, "on the body"}, def.anchor);
    visit({"target", "m", JointMembers::place, "where the anchor is to go"}, def.target);
    visit({"spring", "", Allowed::any, "without it, 5 Hz of the body's mass at a damping ratio of 0.7"}, def.spring);
    visit({"maxForce", "N", JointMembers::strength, "what it may use"}, def.maxForce);
    visit({"breaking", "", Allowed::any, "when it breaks"}, def.breaking);
}

template <>
inline constexpr DefinitionName definitionName<FilterJointDef>{"FilterJointDef", "filter"};
void describe(OrConst<FilterJointDef> auto& def, auto&& visit) {
    visit({"bodyA", "", JointMembers::id, "one body"}, def.bodyA);
    visit({"bodyB", "", JointMembers::id, "the other body"}, def.bodyB);
}

template <>
inline constexpr DefinitionName definitionName<Magnet>{"Magnet", "magnet"};
void describe(OrConst<Magnet> auto& def, auto&& visit) {
    visit({"body", "", Allowed::any, "the body that carries it"}, def.body);
    visit({"pull", "", Allowed::any, "how it draws others; its centre is in the body's frame"}, def.pull);
}

template <>
inline constexpr DefinitionName definitionName<Pool>{"Pool", "pool"};
void describe(OrConst<Pool> auto& def, auto&& visit) {
    visit({"fluid", "", Allowed::any, "what bears the bodies"}, def.fluid);
    visit({"drag", "kg/(m^2 s)", Allowed::notNegative, "force per area under water and speed"}, def.drag);
    visit({"flow", "m/s", Allowed::finite, "the velocity of the fluid"}, def.flow);
}

template <>
inline constexpr DefinitionName definitionName<FieldDef>{"FieldDef"};
void describe(OrConst<FieldDef> auto& def, auto&& visit) {
    visit({"law", "", Allowed::any, "the force that acts on a body"}, def.law);
    visit({"region", "m", Allowed::any, "only on what has its centre of mass here; with an area"}, def.region);
    visit({"filter", "", Allowed::any, "only on what has a shape that collides with a shape of this"}, def.filter);
}

inline constexpr std::array<int, 4> laneCounts{1, 4, 8, 16};

template <>
inline constexpr DefinitionName definitionName<SolverSettings>{"SolverSettings"};
void describe(OrConst<SolverSettings> auto& def, auto&& visit) {
    visit({"subSteps", "-", Allowed::within(1, 64), "in how many parts each step is solved"}, def.subSteps);
    visit({"contactFrequency", "Hz", Allowed::positive, "of contacts, as springs"}, def.contactFrequency);
    visit({"contactDampingRatio", "-", Allowed::positive, "of contacts, as springs"}, def.contactDampingRatio);
    visit({"contactPushSpeed", "m/s", Allowed::positive, "the fastest that overlap is pushed out or shifted apart"},
          def.contactPushSpeed);
    visit({"sleepSpeed", "m/s", Allowed::notNegative, "slower than this everywhere on it, a body counts as still"},
          def.sleepSpeed);
    visit({"sleepTime", "s", Allowed::notNegative, "still for as long as this, an island falls asleep"}, def.sleepTime);
    visit({"lanes", "-", Allowed::among(laneCounts), "at most so many contacts are solved side by side"}, def.lanes);
}

template <>
inline constexpr DefinitionName definitionName<WorldDef>{"WorldDef"};
void describe(OrConst<WorldDef> auto& def, auto&& visit) {
    visit({"gravity", "m/s^2", Allowed::finite, "the same everywhere"}, def.gravity);
    visit({"sleeping", "", Allowed::any, "may what rests be left out of the step?"}, def.sleeping);
    visit({"hitSpeed", "m/s", Allowed::notNegative.orInfinite(), "what comes together faster is a ContactHit"},
          def.hitSpeed);
    visit({"wrap", "", Allowed::any, "how wide and high the world is, if it goes on at its other side"}, def.wrap);
    visit({"ledger", "", Allowed::any, "is account kept of energy and momentum?"}, def.ledger);
    visit({"solver", "", Allowed::any, "how hard the solver tries"}, def.solver);
}

}  // namespace plumb
