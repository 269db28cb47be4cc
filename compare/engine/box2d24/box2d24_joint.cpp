// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_joint.h>

#include <fmt/format.h>

#include <algorithm>

#include <compare/engine/box2d24/box2d24_body.h>
#include <compare/engine/single.h>

namespace plumb::compare {
namespace {

constexpr double farAway = 1e6;  // [m or rad]

class Joiner {
public:
    Joiner(const Built24& built, const JointGeometry& joint, const std::string& name)
        : built_(built), joint_(joint), name_(name) {}

    b2Joint* operator()(const RevoluteJointDef& def) const {
        if (def.spring) refuse("no spring on a hinge");
        b2RevoluteJointDef made;
        place(made);
        made.referenceAngle = made.bodyB->GetAngle() - made.bodyA->GetAngle();
        limit(made, def.limit);
        motor(made, def.motorSpeed, def.maxMotorTorque);
        return create(made);
    }

    b2Joint* operator()(const PrismaticJointDef& def) const {
        if (def.spring) refuse("no spring on a slide");
        b2PrismaticJointDef made;
        place(made);
        made.localAxisA = toBox2d24(joint_.localAxis);
        made.referenceAngle = made.bodyB->GetAngle() - made.bodyA->GetAngle();
        limit(made, def.limit);
        motor(made, def.motorSpeed, def.maxMotorForce);
        return create(made);
    }

    b2Joint* operator()(const DistanceJointDef& def) const {
        if (def.maxMotorForce > 0) refuse("no motor between two points");
        b2DistanceJointDef made;
        place(made);
        made.length = toSingle(*joint_.length);
        if (made.length < b2_linearSlop) refuse(fmt::format("no rod shorter than {} m", b2_linearSlop));
        if (def.spring) {
            spring(made, *def.spring);
            made.minLength = toSingle(def.minLength);
            made.maxLength = toSingleAtMost(def.maxLength);
        } else {
            made.minLength = made.maxLength = made.length;  // no stiffness: a rigid rod
        }
        return create(made);
    }

    b2Joint* operator()(const WeldJointDef& def) const {
        if (def.spring) refuse("no weld whose anchor gives");
        b2WeldJointDef made;
        place(made);
        made.referenceAngle = made.bodyB->GetAngle() - made.bodyA->GetAngle();
        if (def.bending && def.bending->stiffness == 0) refuse("no weld that bends without stiffness");
        if (def.bending) spring(made, *def.bending);
        return create(made);
    }

    b2Joint* operator()(const WheelJointDef& def) const {
        b2WheelJointDef made;
        place(made);
        made.localAxisA = toBox2d24(joint_.localAxis);
        // The wheel's spring rests where the anchors meet, so the anchors are set apart by restShift.
        made.localAnchorA = toBox2d24(joint_.localAnchorA + def.restShift * joint_.localAxis);
        limit(made, def.limit, def.restShift);
        motor(made, def.motorSpeed, def.maxMotorTorque);
        if (def.spring) spring(made, *def.spring);
        return create(made);
    }

    b2Joint* operator()(const PulleyJointDef& def) const {
        b2PulleyJointDef made;
        place(made);
        const auto apart = [](const Vec2& a, const Vec2& b) { return toSingle((a - b).norm()); };
        made.groundAnchorA = toBox2d24(def.groundA);
        made.groundAnchorB = toBox2d24(def.groundB);
        made.lengthA = apart(def.groundA, def.anchorA);
        made.lengthB = apart(def.groundB, def.anchorB);
        made.ratio = toSingle(def.ratio);
        return create(made);
    }

    b2Joint* operator()(const GearJointDef& def) const {
        b2GearJointDef made;
        made.joint1 = built_.joints[joint_.jointA];
        made.joint2 = built_.joints[joint_.jointB];
        made.bodyA = made.joint1->GetBodyB();
        made.bodyB = made.joint2->GetBodyB();
        if (made.bodyA == made.bodyB) refuse("no gear that drives one body by two joints");
        made.collideConnected = true;
        made.ratio = toSingle(def.ratio);
        return built_.world.CreateJoint(&made);
    }

    b2Joint* operator()(const MotorJointDef& def) const {
        if (def.velocity != Vec2(0, 0) || def.angularVelocity != 0) refuse("no motor joint that moves at a velocity");
        b2MotorJointDef made;
        ends(made);
        made.linearOffset = def.offset ? toBox2d24(*def.offset) : made.bodyA->GetLocalPoint(made.bodyB->GetPosition());
        made.angularOffset = def.angle ? toSingle(*def.angle) : made.bodyB->GetAngle() - made.bodyA->GetAngle();
        made.maxForce = toSingleAtMost(def.maxForce);
        made.maxTorque = toSingleAtMost(def.maxTorque);
        made.correctionFactor = toSingle(std::min(def.rate * built_.scene.dt, 1.0));
        return create(made);
    }

    b2Joint* operator()(const TargetJointDef& def) const {
        const Spring its = springOf(def, built_.scene.bodies[joint_.bodyB].def);
        b2MouseJointDef made;
        const b2BodyDef ground;
        made.bodyA = built_.world.CreateBody(&ground);
        made.bodyB = built_.bodies[joint_.bodyB];
        made.collideConnected = true;
        made.maxForce = toSingleAtMost(def.maxForce);
        spring(made, its);
        made.target = toBox2d24(def.anchor);  // here the joint takes hold of the body
        auto* mouse = static_cast<b2MouseJoint*>(built_.world.CreateJoint(&made));
        mouse->SetTarget(toBox2d24(def.target));
        return mouse;
    }

    /// A friction joint without force, which keeps the bodies from touching.
    b2Joint* operator()(const FilterJointDef&) const {
        b2FrictionJointDef made;
        place(made);
        made.collideConnected = false;
        return create(made);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Unsupported(fmt::format("joint {}: Box2D 2.4 has {}", name_, what));
    }

    void ends(b2JointDef& made) const {
        made.bodyA = built_.bodies[joint_.bodyA];
        made.bodyB = built_.bodies[joint_.bodyB];
        made.collideConnected = joint_.collideConnected;
    }

    void place(auto& made) const {
        ends(made);
        made.localAnchorA = toBox2d24(joint_.localAnchorA);
        made.localAnchorB = toBox2d24(joint_.localAnchorB);
    }

    /// Box2D's springs have stiffness and damping like the scene's. Without stiffness, there is no damping either.
    void spring(auto& made, const Spring& spring) const {
        if (spring.stiffness == 0 && spring.damping > 0) refuse("no damper without a spring");
        made.stiffness = toSingle(spring.stiffness);
        made.damping = toSingle(spring.damping);
    }

    static void limit(auto& made, const std::optional<Limit>& limit, double rest = 0) {
        if (!limit) return;
        made.enableLimit = true;
        const float lower = toSingle(std::max(limit->lower - rest, -farAway));
        const float upper = toSingle(std::min(limit->upper - rest, farAway));
        if constexpr (requires { made.lowerAngle; }) {
            made.lowerAngle = lower;
            made.upperAngle = upper;
        } else {
            made.lowerTranslation = lower;
            made.upperTranslation = upper;
        }
    }

    static void motor(auto& made, double speed, double most) {
        made.enableMotor = most > 0;
        made.motorSpeed = toSingle(speed);
        if constexpr (requires { made.maxMotorTorque; })
            made.maxMotorTorque = toSingleAtMost(most);
        else
            made.maxMotorForce = toSingleAtMost(most);
    }

    b2Joint* create(const auto& made) const { return built_.world.CreateJoint(&made); }

    const Built24& built_;
    const JointGeometry& joint_;
    const std::string& name_;
};

}  // namespace

b2Joint* addJoint24(const Built24& built, const JointGeometry& joint, const std::string& name) {
    return std::visit(Joiner(built, joint, name), joint.def);
}

}  // namespace plumb::compare
