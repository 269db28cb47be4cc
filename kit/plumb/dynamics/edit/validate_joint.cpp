// SPDX-License-Identifier: MIT
// Which joints may be added? validate_joint_def.cpp checks their numbers; this file checks what depends on the world.
#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include <plumb/dynamics/describe.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>

namespace plumb {

namespace {

/// Does each id name an object of this world to which a joint can be attached?
struct IdCheck {
    const WorldState& world;
    const MemberPath& path;

    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_same_v<T, BodyId>) requireBody(world, value, path.text(member.name));
        if constexpr (std::is_same_v<T, JointId>) requireGeared(value, path.text(member.name));
    }

private:
    void requireGeared(JointId joint, const std::string& field) const {
        requireJoint(world, joint, field);
        const AnyJoint& kind = world.joints[joint.index].joint;
        if (!std::holds_alternative<RevoluteJoint>(kind) && !std::holds_alternative<PrismaticJoint>(kind))
            refuse(field, textOf(joint) + " is neither revolute nor prismatic, so it cannot be geared");
    }
};

/// The two bodies must differ, and one must be dynamic, unless the joint only keeps them from touching.
template <class Def>
requires requires(const Def& d) {
    d.bodyA;
}
void requireBodies(const WorldState& world, const Def& def, const MemberPath& path) {
    if (def.bodyA == def.bodyB)
        refuse(path.text("bodyB"), textOf(def.bodyB) + " is the same body as bodyA, two were wanted");
    if (std::is_same_v<Def, FilterJointDef>) return;
    if (!world.bodies.isDynamic(def.bodyA.index) && !world.bodies.isDynamic(def.bodyB.index))
        refuse(path.text("bodyB"),
               textOf(def.bodyB) + " is not dynamic, nor is bodyA, so the joint could move nothing");
}

void requireBodies(const WorldState& world, const TargetJointDef& def, const MemberPath& path) {
    if (!world.bodies.isDynamic(def.body.index))
        refuse(path.text("body"), textOf(def.body) + " is not dynamic, so the joint could move nothing");
}

void requireBodies(const WorldState&, const GearJointDef& def, const MemberPath& path) {
    if (def.jointA == def.jointB)
        refuse(path.text("jointB"), textOf(def.jointB) + " is the same joint as jointA, two were wanted");
}

/// Is each anchor near its bodies? A longer arm would be too coarse in the solver's floats.
struct AnchorCheck {
    const WorldState& world;
    const MemberPath& path;
    std::vector<BodyId> bodies = {};

    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) {
        if constexpr (std::is_same_v<T, BodyId>) bodies.push_back(value);
        if constexpr (std::is_same_v<T, Vec2>) {
            const AnchorOf of = member.allowed.anchor;
            if (of == AnchorOf::First || of == AnchorOf::Both) requireNear(bodies.at(0), value, member.name);
            if (of == AnchorOf::Second || of == AnchorOf::Both) requireNear(bodies.at(1), value, member.name);
        }
    }

private:
    void requireNear(BodyId body, const Vec2& anchor, const char* member) const {
        constexpr double longest = 1e5;
        const Vec2& center = world.bodies.motion[body.index].center;
        if ((world.bodies.near(anchor, center) - center).norm() <= longest) return;
        refuse(path.text(member), toText(anchor) + " is more than " + toText(longest) + " m from the body it is on");
    }
};

/// Refuses a value that would do nothing for want of another: why tells which.
void requireUse(bool used, const MemberPath& path, const char* member, double value, const char* why) {
    if (!used) refuse(path.text(member), toText(value) + " does nothing " + why);
}

template <class Def>
void requireMotor(const Def& def, const MemberPath& path) {
    if constexpr (requires { def.maxMotorTorque; })
        requireUse(def.motorSpeed == 0 || def.maxMotorTorque != 0, path, "motorSpeed", def.motorSpeed,
                   "while maxMotorTorque is 0");
    else
        requireUse(def.motorSpeed == 0 || def.maxMotorForce != 0, path, "motorSpeed", def.motorSpeed,
                   "while maxMotorForce is 0");
}

/// Does each number of a new joint do something? A motor may be switched off later by set(), with its speed kept.
template <class Def>
void requireEffect(const Def& def, const MemberPath& path) {
    const char* const noSpring = "without a spring";
    if constexpr (requires { def.restAngle; })
        requireUse(def.spring || def.restAngle == 0, path, "restAngle", def.restAngle, noSpring);
    if constexpr (requires { def.restShift; })
        requireUse(def.spring || def.restShift == 0, path, "restShift", def.restShift, noSpring);
    if constexpr (requires { def.maxLength; }) {
        requireUse(def.spring || def.minLength == 0, path, "minLength", def.minLength, noSpring);
        requireUse(def.spring || def.maxLength == unlimited, path, "maxLength", def.maxLength, noSpring);
        requireUse(def.spring || def.maxMotorForce == 0, path, "maxMotorForce", def.maxMotorForce, noSpring);
    }
    if constexpr (requires { def.motorSpeed; }) requireMotor(def, path);
}

/// The members of a joint that cannot be changed later, in the order in which they are described.
struct Given {
    const char* member;
    std::variant<BodyId, JointId, Vec2> value;

    std::string text() const {
        return std::visit(
            [](const auto& v) {
                if constexpr (requires { textOf(v); })
                    return textOf(v);
                else
                    return toText(v);
            },
            value);
    }
};

/// Reads from the descriptions which members these are, so a new kind of joint needs no list of its own.
struct GivenOnce {
    std::vector<Given> all = {};

    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) {
        if constexpr (std::is_same_v<T, BodyId> || std::is_same_v<T, JointId> || std::is_same_v<T, Vec2>)
            if (member.allowed.once) all.push_back({member.name, value});
    }
};

std::vector<Given> givenOnce(const JointDef& def) {
    GivenOnce given;
    std::visit([&given](const auto& kind) { describe(kind, given); }, def);
    return given.all;
}

}  // namespace

std::string nameOf(const JointDef& def) {
    return std::visit([]<class Def>(const Def&) { return definitionName<Def>.type; }, def);
}

/// Ids come first, because the later checks look at their bodies; then each number; then what numbers do together; and
/// last the anchors, when their coordinates are known to be finite.
void validate(const WorldState& world, const JointDef& def) {
    const std::string name = nameOf(def);
    const MemberPath path{name};
    std::visit(
        [&](const auto& kind) {
            describe(kind, IdCheck{world, path});
            requireBodies(world, kind, path);
        },
        def);
    validate(def, name);
    std::visit([&](const auto& kind) { requireEffect(kind, path); }, def);
    std::visit([&](const auto& kind) { describe(kind, AnchorCheck{world, path}); }, def);
}

/// For Joint::setMotorSpeed, which sets a speed in order to have an effect.
void requireMotor(const JointDef& def) {
    const std::string name = nameOf(def);
    const auto check = [&name](const auto& kind) {
        if constexpr (requires { kind.motorSpeed; }) requireMotor(kind, MemberPath{name});
    };
    std::visit(check, def);
}

/// A joint keeps its anchors and its impulses when it is set; with other bodies it would be another joint.
void validateChange(const JointDef& from, const JointDef& to) {
    const std::string name = nameOf(to);
    if (from.index() != to.index())
        refuse("JointDef",
               name + " is of another kind than the joint, a " + nameOf(from) + "; remove it and join anew");
    const std::vector<Given> before = givenOnce(from), after = givenOnce(to);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (!(before[i].value == after[i].value))
            refuse(name + "." + before[i].member, after[i].text() + " is not " + before[i].text() +
                                                      ", which the joint was made with; remove it and join anew");
    // The world is not checked here: since the joint was made, its bodies may have moved far from its anchors, or may
    // no longer be dynamic.
    validate(to, name);
}

}  // namespace plumb
