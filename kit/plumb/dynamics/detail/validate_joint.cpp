// SPDX-License-Identifier: MIT
#include <string>
#include <variant>

#include <plumb/dynamics/detail/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// A def's parts are checked under its name.
class DefCheck {
public:
    DefCheck(const WorldState& world, std::string name) : world_(world), name_(std::move(name)) {}

    std::string field(const char* member) const { return name_ + "." + member; }

    void bodies(BodyId a, BodyId b) const {
        requireBody(world_, a, field("bodyA"));
        requireBody(world_, b, field("bodyB"));
        if (a == b) refuse(field("bodyB"), "is the same body as bodyA, two were wanted");
        if (!world_.bodies.isDynamic(a.index) && !world_.bodies.isDynamic(b.index))
            refuse(field("bodyB"), "neither it nor bodyA is dynamic, so the joint could move nothing");
    }

    /// An arm that is longer would be too coarse in the solver's floats.
    void anchor(BodyId body, const Vec2& anchor, const char* member) const {
        constexpr double longest = 1e5;
        requireFinite(anchor, name_, std::string(".") + member);
        if ((anchor - world_.bodies.motion[body.index].center).norm() <= longest) return;
        refuse(field(member), toText(anchor) + " is more than " + toText(longest) + " m from the body it is on");
    }

    void axis(const Vec2& axis) const {
        requireFinite(axis, field("axis"));
        if (axis.isZero(0)) refuse(field("axis"), "(0, 0) has no direction");
    }

    void finite(double value, const char* member) const { requireFinite(value, field(member)); }
    void notNegative(double value, const char* member) const { requireNotNegative(value, field(member)); }

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

    const WorldState& world() const { return world_; }

private:
    const WorldState& world_;
    std::string name_;
};

struct Validator {
    const WorldState& world;

    void operator()(const RevoluteJointDef& d) const {
        const DefCheck check(world, "RevoluteJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.finite(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorTorque, "maxMotorTorque");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.finite(d.restAngle, "restAngle");
        check.breaking(d.breaking);
    }
    void operator()(const PrismaticJointDef& d) const {
        const DefCheck check(world, "PrismaticJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.axis(d.axis);
        check.finite(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorForce, "maxMotorForce");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.finite(d.restShift, "restShift");
        check.breaking(d.breaking);
    }
    void operator()(const DistanceJointDef& d) const {
        const DefCheck check(world, "DistanceJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchorA, "anchorA");
        check.anchor(d.bodyB, d.anchorB, "anchorB");
        if (d.length) requirePositive(*d.length, check.field("length"));
        if (!d.spring && d.anchorA == d.anchorB)
            refuse(check.field("anchorB"), toText(d.anchorB) + " is anchorA too, so the rod would have no direction");
        check.spring(d.spring, "spring");
        check.notNegative(d.minLength, "minLength");
        check.bound(d.maxLength, "maxLength");
        if (d.maxLength < d.minLength)
            refuse(check.field("maxLength"), toText(d.maxLength) + " is less than minLength " + toText(d.minLength));
        check.finite(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorForce, "maxMotorForce");
        check.breaking(d.breaking);
    }
    void operator()(const WeldJointDef& d) const {
        const DefCheck check(world, "WeldJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.spring(d.spring, "spring");
        check.spring(d.bending, "bending");
        check.breaking(d.breaking);
    }
    void operator()(const WheelJointDef& d) const {
        const DefCheck check(world, "WheelJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchor, "anchor");
        check.anchor(d.bodyB, d.anchor, "anchor");
        check.axis(d.axis);
        check.finite(d.motorSpeed, "motorSpeed");
        check.bound(d.maxMotorTorque, "maxMotorTorque");
        check.limit(d.limit);
        check.spring(d.spring, "spring");
        check.finite(d.restShift, "restShift");
        check.breaking(d.breaking);
    }
    void operator()(const PulleyJointDef& d) const {
        const DefCheck check(world, "PulleyJointDef");
        check.bodies(d.bodyA, d.bodyB);
        check.anchor(d.bodyA, d.anchorA, "anchorA");
        check.anchor(d.bodyB, d.anchorB, "anchorB");
        requireFinite(d.groundA, check.field("groundA"));
        requireFinite(d.groundB, check.field("groundB"));
        if (d.groundA == d.anchorA)
            refuse(check.field("groundA"), toText(d.groundA) + " is anchorA too, so the rope would have no direction");
        if (d.groundB == d.anchorB)
            refuse(check.field("groundB"), toText(d.groundB) + " is anchorB too, so the rope would have no direction");
        requirePositive(d.ratio, check.field("ratio"));
        check.breaking(d.breaking);
    }
    void operator()(const GearJointDef& d) const {
        const DefCheck check(world, "GearJointDef");
        requireGeared(d.jointA, check.field("jointA"));
        requireGeared(d.jointB, check.field("jointB"));
        if (d.jointA == d.jointB) refuse(check.field("jointB"), "is the same joint as jointA, two were wanted");
        check.finite(d.ratio, "ratio");
        if (d.ratio == 0) refuse(check.field("ratio"), "0 would gear nothing");
        check.breaking(d.breaking);
    }
    void operator()(const MotorJointDef& d) const {
        const DefCheck check(world, "MotorJointDef");
        check.bodies(d.bodyA, d.bodyB);
        if (d.offset) requireFinite(*d.offset, check.field("offset"));
        if (d.angle) check.finite(*d.angle, "angle");
        check.notNegative(d.rate, "rate");
        requireFinite(d.velocity, check.field("velocity"));
        check.finite(d.angularVelocity, "angularVelocity");
        check.bound(d.maxForce, "maxForce");
        check.bound(d.maxTorque, "maxTorque");
        check.breaking(d.breaking);
    }
    void operator()(const TargetJointDef& d) const {
        const DefCheck check(world, "TargetJointDef");
        requireBody(world, d.body, check.field("body"));
        if (!world.bodies.isDynamic(d.body.index))
            refuse(check.field("body"), "is not dynamic, so the joint could move nothing");
        check.anchor(d.body, d.anchor, "anchor");
        requireFinite(d.target, check.field("target"));
        check.spring(d.spring, "spring");
        check.bound(d.maxForce, "maxForce");
        check.breaking(d.breaking);
    }
    void operator()(const FilterJointDef& d) const {
        requireBody(world, d.bodyA, "FilterJointDef.bodyA");
        requireBody(world, d.bodyB, "FilterJointDef.bodyB");
        if (d.bodyA == d.bodyB) refuse("FilterJointDef.bodyB", "is the same body as bodyA, two were wanted");
    }

    void requireGeared(JointId joint, const std::string& field) const {
        requireJoint(world, joint, field);
        const AnyJoint& kind = world.joints[joint.index].joint;
        if (!std::holds_alternative<RevoluteJoint>(kind) && !std::holds_alternative<PrismaticJoint>(kind))
            refuse(field, "is neither revolute nor prismatic, so it cannot be geared");
    }
};

/// What a joint cannot change, once it is made.
struct Frame {
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    std::vector<Vec2> points;
    friend bool operator==(const Frame&, const Frame&) = default;
};

Frame frameOf(const JointDef& def) {
    return std::visit(
        []<class Def>(const Def& d) -> Frame {
            Frame frame;
            if constexpr (requires { d.bodyA; }) frame.bodies = {d.bodyA, d.bodyB};
            if constexpr (requires { d.body; }) frame.bodies = {d.body};
            if constexpr (requires { d.jointA; }) frame.joints = {d.jointA, d.jointB};
            if constexpr (requires { d.anchor; }) frame.points.push_back(d.anchor);
            if constexpr (requires { d.anchorA; }) frame.points.insert(frame.points.end(), {d.anchorA, d.anchorB});
            if constexpr (requires { d.groundA; }) frame.points.insert(frame.points.end(), {d.groundA, d.groundB});
            if constexpr (requires { d.axis; }) frame.points.push_back(d.axis);
            return frame;
        },
        def);
}

}  // namespace

void validate(const WorldState& world, const JointDef& def) {
    std::visit(Validator{world}, def);
}

void validateChange(const WorldState& world, const JointDef& from, const JointDef& to) {
    if (from.index() != to.index()) refuse("JointDef", "is of another kind than the joint; remove it and join anew");
    if (frameOf(from) != frameOf(to))
        refuse("JointDef", "has other bodies, joints, anchors or axes than the joint; remove it and join anew");
    // The bodies may have gone far from where the anchors were named; they were near enough then.
    struct Moved : Validator {};
    validate(world, to);
}

}  // namespace plumb
