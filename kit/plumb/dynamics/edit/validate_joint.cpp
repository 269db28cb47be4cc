// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <string>
#include <variant>

#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// A def's parts are checked under its name. Of a joint that is made already, bodies and anchors are known to be those
/// that it has: these may have gone far from there, or be held fast by now.
class DefCheck {
public:
    DefCheck(const WorldState& world, std::string name, bool made)
        : world_(world), name_(std::move(name)), made_(made) {}

    std::string field(const char* member) const { return name_ + "." + member; }

    void twoBodies(BodyId a, BodyId b) const {
        requireBody(world_, a, field("bodyA"));
        requireBody(world_, b, field("bodyB"));
        if (a == b) refuse(field("bodyB"), textOf(b) + " is the same body as bodyA, two were wanted");
    }

    void bodies(BodyId a, BodyId b) const {
        if (made_) return;
        twoBodies(a, b);
        if (!world_.bodies.isDynamic(a.index) && !world_.bodies.isDynamic(b.index))
            refuse(field("bodyB"), textOf(b) + " is not dynamic, nor is bodyA, so the joint could move nothing");
    }

    /// An arm that is longer would be too coarse in the solver's floats.
    void anchor(BodyId body, const Vec2& anchor, const char* member) const {
        if (made_) return;
        constexpr double longest = 1e5;
        requireFinite(anchor, name_, std::string(".") + member);
        if ((world_.bodies.near(anchor, world_.bodies.motion[body.index].center) -
             world_.bodies.motion[body.index].center)
                .norm() <= longest)
            return;
        refuse(field(member), toText(anchor) + " is more than " + toText(longest) + " m from the body it is on");
    }

    void axis(const Vec2& axis) const {
        requireFinite(axis, field("axis"));
        if (axis.isZero(0)) refuse(field("axis"), "(0, 0) has no direction");
    }

    void finite(double value, const char* member) const { requireFinite(value, field(member)); }
    void notNegative(double value, const char* member) const { requireNotNegative(value, field(member)); }

    /// Of where a body is to be, or how it is to move: farther or faster it would be put in quarantine.
    void within(double value, const char* member) const {
        finite(value, member);
        if (std::fabs(value) > farthest) refuse(field(member), toText(value) + beyond());
    }
    void within(const Vec2& value, const char* member) const {
        requireFinite(value, field(member));
        if (value.cwiseAbs().maxCoeff() > farthest) refuse(field(member), toText(value) + beyond());
    }

    /// Not negative, and may be infinite.
    void bound(double value, const char* member) const {
        if (value != unlimited) requireNotNegative(value, field(member));
    }

    void limit(const std::optional<Limit>& limit) const {
        if (!limit) return;
        if (limit->lower != -unlimited) finite(limit->lower, "limit.lower");
        if (limit->upper != unlimited) finite(limit->upper, "limit.upper");
        if (!(limit->lower <= limit->upper))
            refuse(field("limit.lower"), toText(limit->lower) + " is more than limit.upper " + toText(limit->upper));
    }

    void spring(const std::optional<Spring>& spring, const std::string& member) const {
        if (!spring) return;
        notNegative(spring->stiffness, (member + ".stiffness").c_str());
        notNegative(spring->damping, (member + ".damping").c_str());
    }

    void breaking(const Breaking& breaking) const {
        if (breaking.force != unlimited) requirePositive(breaking.force, field("breaking.force"));
        if (breaking.torque != unlimited) requirePositive(breaking.torque, field("breaking.torque"));
    }

private:
    static constexpr double farthest = 1e15;
    static std::string beyond() {
        return " is beyond " + toText(farthest) + ", where no body can be, nor move so fast";
    }

    const WorldState& world_;
    std::string name_;
    bool made_;
};

struct Validator {
    const WorldState& world;
    bool made = false;

    void operator()(const RevoluteJointDef& d) const {
        const DefCheck check(world, "RevoluteJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.within(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorTorque, "maxMotorTorque");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.within(d.restAngle, "restAngle");
        check.breaking(d.breaking);
    }
    void operator()(const PrismaticJointDef& d) const {
        const DefCheck check(world, "PrismaticJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.axis(d.axis);
        check.within(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorForce, "maxMotorForce");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.within(d.restShift, "restShift");
        check.breaking(d.breaking);
    }
    void operator()(const DistanceJointDef& d) const {
        const DefCheck check(world, "DistanceJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchorA, "anchorA");
        check.anchor(d.bodyB, d.anchorB, "anchorB");
        if (d.length) {
            requirePositive(*d.length, check.field("length"));
            check.within(*d.length, "length");
        }
        if (!d.spring && d.anchorA == d.anchorB)
            refuse(check.field("anchorB"), toText(d.anchorB) + " is anchorA too, so the rod would have no direction");
        check.spring(d.spring, "spring");
        check.notNegative(d.minLength, "minLength");
        check.bound(d.maxLength, "maxLength");
        if (d.maxLength < d.minLength)
            refuse(check.field("maxLength"), toText(d.maxLength) + " is less than minLength " + toText(d.minLength));
        check.within(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorForce, "maxMotorForce");
        check.breaking(d.breaking);
    }
    void operator()(const WeldJointDef& d) const {
        const DefCheck check(world, "WeldJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.spring(d.spring, "spring");
        check.spring(d.bending, "bending");
        check.breaking(d.breaking);
    }
    void operator()(const WheelJointDef& d) const {
        const DefCheck check(world, "WheelJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.axis(d.axis);
        check.within(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorTorque, "maxMotorTorque");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.within(d.restShift, "restShift");
        check.breaking(d.breaking);
    }
    void operator()(const PulleyJointDef& d) const {
        const DefCheck check(world, "PulleyJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchorA, "anchorA");
        check.anchor(d.bodyB, d.anchorB, "anchorB");
        check.within(d.groundA, "groundA");
        check.within(d.groundB, "groundB");
        if (d.groundA == d.anchorA)
            refuse(check.field("groundA"), toText(d.groundA) + " is anchorA too, so the rope would have no direction");
        if (d.groundB == d.anchorB)
            refuse(check.field("groundB"), toText(d.groundB) + " is anchorB too, so the rope would have no direction");
        requirePositive(d.ratio, check.field("ratio"));
        check.within(d.ratio, "ratio");
        check.breaking(d.breaking);
    }
    void operator()(const GearJointDef& d) const {
        const DefCheck check(world, "GearJointDef", made);
        requireGeared(d.jointA, check.field("jointA"));
        requireGeared(d.jointB, check.field("jointB"));
        if (d.jointA == d.jointB)
            refuse(check.field("jointB"), textOf(d.jointB) + " is the same joint as jointA, two were wanted");
        check.within(d.ratio, "ratio");
        if (d.ratio == 0) refuse(check.field("ratio"), "0 would gear nothing");
        check.breaking(d.breaking);
    }
    void operator()(const MotorJointDef& d) const {
        const DefCheck check(world, "MotorJointDef", made);
        check.bodies(d.bodyA, d.bodyB);
        if (d.offset) check.within(*d.offset, "offset");
        if (d.angle) check.within(*d.angle, "angle");
        check.notNegative(d.rate, "rate");
        check.within(d.rate, "rate");
        check.within(d.velocity, "velocity");
        check.within(d.angularVelocity, "angularVelocity");
        check.bound(d.maxForce, "maxForce");
        check.bound(d.maxTorque, "maxTorque");
        check.breaking(d.breaking);
    }
    void operator()(const TargetJointDef& d) const {
        const DefCheck check(world, "TargetJointDef", made);
        requireBody(world, d.body, check.field("body"));
        if (!made && !world.bodies.isDynamic(d.body.index))
            refuse(check.field("body"), textOf(d.body) + " is not dynamic, so the joint could move nothing");
        check.anchor(d.body, d.anchor, "anchor");
        check.within(d.target, "target");
        check.spring(d.spring, "spring");
        check.bound(d.maxForce, "maxForce");
        check.breaking(d.breaking);
    }
    void operator()(const FilterJointDef& d) const {
        DefCheck(world, "FilterJointDef", made).twoBodies(d.bodyA, d.bodyB);
    }

    void requireGeared(JointId joint, const std::string& field) const {
        requireJoint(world, joint, field);
        const AnyJoint& kind = world.joints[joint.index].joint;
        if (!std::holds_alternative<RevoluteJoint>(kind) && !std::holds_alternative<PrismaticJoint>(kind))
            refuse(field, textOf(joint) + " is neither revolute nor prismatic, so it cannot be geared");
    }
};

/// What a joint cannot change, once it is made: one by one, each with its name.
struct Frame {
    const char* member = "";
    std::string before, after;

    template <class Value>
    void compare(const char* which, const Value& from, const Value& to) {
        if (*member != 0 || from == to) return;
        member = which;
        before = text(from);
        after = text(to);
    }
    static std::string text(const Vec2& v) { return toText(v); }
    template <class Id>
    static std::string text(const Id& id) {
        return textOf(id);
    }
};

template <class Def>
Frame changeOf(const Def& a, const Def& b) {
    Frame frame;
    if constexpr (requires { a.bodyA; }) frame.compare(".bodyA", a.bodyA, b.bodyA);
    if constexpr (requires { a.bodyA; }) frame.compare(".bodyB", a.bodyB, b.bodyB);
    if constexpr (requires { a.body; }) frame.compare(".body", a.body, b.body);
    if constexpr (requires { a.jointA; }) frame.compare(".jointA", a.jointA, b.jointA);
    if constexpr (requires { a.jointA; }) frame.compare(".jointB", a.jointB, b.jointB);
    if constexpr (requires { a.anchor; }) frame.compare(".anchor", a.anchor, b.anchor);
    if constexpr (requires { a.anchorA; }) frame.compare(".anchorA", a.anchorA, b.anchorA);
    if constexpr (requires { a.anchorA; }) frame.compare(".anchorB", a.anchorB, b.anchorB);
    if constexpr (requires { a.groundA; }) frame.compare(".groundA", a.groundA, b.groundA);
    if constexpr (requires { a.groundA; }) frame.compare(".groundB", a.groundB, b.groundB);
    if constexpr (requires { a.axis; }) frame.compare(".axis", a.axis, b.axis);
    return frame;
}

}  // namespace

std::string nameOf(const JointDef& def) {
    constexpr std::array names{"RevoluteJointDef", "PrismaticJointDef", "DistanceJointDef", "WeldJointDef",
                               "WheelJointDef",    "PulleyJointDef",    "GearJointDef",     "MotorJointDef",
                               "TargetJointDef",   "FilterJointDef"};
    static_assert(names.size() == std::variant_size_v<JointDef>);
    return names[def.index()];
}

void validate(const WorldState& world, const JointDef& def) {
    std::visit(Validator{world}, def);
}

void validateChange(const WorldState& world, const JointDef& from, const JointDef& to) {
    if (from.index() != to.index())
        refuse("JointDef",
               nameOf(to) + " is of another kind than the joint, a " + nameOf(from) + "; remove it and join anew");
    std::visit(
        [&]<class Def>(const Def& before) {
            const Frame frame = changeOf(before, std::get<Def>(to));
            if (*frame.member != 0)
                refuse(nameOf(to) + frame.member, frame.after + " is not " + frame.before +
                                                      ", which the joint was made with; remove it and join anew");
        },
        from);
    std::visit(Validator{world, true}, to);
}

}  // namespace plumb
