// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_joint.h>

#include <box2d/constants.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <compare/engine/box2d3/box2d3_body.h>
#include <compare/engine/effective_mass.h>
#include <compare/engine/single.h>

namespace plumb::compare {
namespace {

constexpr double farAway = 1e5;                          // [m]
constexpr double widestAngle = 0.99 * std::numbers::pi;  // Box2D 3 reduces a larger limit to this [rad]

b2Rot toRot(const Vec2& cosSin) {
    return {static_cast<float>(cosSin.x()), static_cast<float>(cosSin.y())};
}

class Joiner {
public:
    Joiner(const Built3& built, const JointGeometry& joint, std::size_t index)
        : built_(built), joint_(joint), index_(index) {}

    b2JointId operator()(const RevoluteJointDef& def) const {
        b2RevoluteJointDef made = b2DefaultRevoluteJointDef();
        place(made.base);
        motor(made, def.motorSpeed, def.maxMotorTorque);
        made.maxMotorTorque = toSingleAtMost(def.maxMotorTorque);
        if (def.limit) {
            if (def.limit->lower < -widestAngle || def.limit->upper > widestAngle)
                refuse(fmt::format("no limit of an angle beyond {:.3f}", widestAngle));
            made.enableLimit = true;
            made.lowerAngle = toSingle(def.limit->lower);
            made.upperAngle = toSingle(def.limit->upper);
        }
        spring(made, def.spring, effectiveInertia(built_.scene, joint_));
        if (std::abs(def.restAngle) > std::numbers::pi) refuse("no spring that turns farther than half a turn");
        made.targetAngle = toSingle(def.restAngle);
        return b2CreateRevoluteJoint(built_.world, &made);
    }

    b2JointId operator()(const PrismaticJointDef& def) const {
        b2PrismaticJointDef made = b2DefaultPrismaticJointDef();
        placeAlong(made.base);
        motor(made, def.motorSpeed, def.maxMotorForce);
        made.maxMotorForce = toSingleAtMost(def.maxMotorForce);
        limit(made, def.limit);
        spring(made, def.spring, effectiveMass(built_.scene, joint_, axis()));
        made.targetTranslation = toSingle(def.restShift);
        return b2CreatePrismaticJoint(built_.world, &made);
    }

    b2JointId operator()(const DistanceJointDef& def) const {
        b2DistanceJointDef made = b2DefaultDistanceJointDef();
        place(made.base);
        made.length = toSingle(*joint_.length);
        if (made.length < B2_LINEAR_SLOP) refuse(fmt::format("no rod shorter than {} m", B2_LINEAR_SLOP));
        const Vec2 along = def.anchorB - def.anchorA;
        const Vec2 direction = along.norm() > 0 ? Vec2(along.normalized()) : down();
        spring(made, def.spring, effectiveMass(built_.scene, joint_, direction));  // a rigid rod if there is no spring
        if (def.spring && (def.minLength > 0 || def.maxLength < unlimited)) {
            made.enableLimit = true;
            made.minLength = toSingle(def.minLength);
            made.maxLength = toSingle(std::min(def.maxLength, farAway));
        }
        motor(made, def.motorSpeed, def.maxMotorForce);
        made.maxMotorForce = toSingleAtMost(def.maxMotorForce);
        return b2CreateDistanceJoint(built_.world, &made);
    }

    b2JointId operator()(const WeldJointDef& def) const {
        b2WeldJointDef made = b2DefaultWeldJointDef();
        place(made.base);
        for (const std::optional<Spring>& spring : {def.spring, def.bending})
            if (spring && spring->stiffness == 0) refuse("no weld that gives without stiffness");
        if (def.spring) {
            const Frequency linear = frequencyOf(*def.spring, effectiveMass(built_.scene, joint_, down()));
            made.linearHertz = toSingle(linear.hertz);
            made.linearDampingRatio = toSingle(linear.dampingRatio);
        }
        if (def.bending) {
            const Frequency angular = frequencyOf(*def.bending, effectiveInertia(built_.scene, joint_));
            made.angularHertz = toSingle(angular.hertz);
            made.angularDampingRatio = toSingle(angular.dampingRatio);
        }
        return b2CreateWeldJoint(built_.world, &made);
    }

    b2JointId operator()(const WheelJointDef& def) const {
        b2WheelJointDef made = b2DefaultWheelJointDef();
        placeAlong(made.base);
        // The wheel's spring rests where the frames meet, so the frames are set apart by restShift.
        made.base.localFrameA.p = toBox2d3(joint_.localAnchorA + def.restShift * joint_.localAxis);
        motor(made, def.motorSpeed, def.maxMotorTorque);
        made.maxMotorTorque = toSingleAtMost(def.maxMotorTorque);
        limit(made, def.limit, def.restShift);
        spring(made, def.spring, effectiveMass(built_.scene, joint_, axis()));
        return b2CreateWheelJoint(built_.world, &made);
    }

    b2JointId operator()(const PulleyJointDef&) const { refuse("no pulley"); }
    b2JointId operator()(const GearJointDef&) const { refuse("no gear"); }

    /// With a rate, the motor is a spring with so much damping that it never swings: b2MakeSoft's bias w / (2 z + h w)
    /// is the rate. Without a rate, there is only a limit for the force and torque that bring the velocity to the
    /// wanted one.
    b2JointId operator()(const MotorJointDef& def) const {
        const bool moves = def.velocity != Vec2(0, 0) || def.angularVelocity != 0;
        if (moves && def.rate > 0) refuse("no motor joint that holds a pose and moves at a velocity");
        b2MotorJointDef made = b2DefaultMotorJointDef();
        place(made.base);
        const BodyDef &a = bodyDef(joint_.bodyA), &b = bodyDef(joint_.bodyB);
        if (def.offset)
            made.base.localFrameA.p = toBox2d3(*def.offset);
        else
            made.base.localFrameA.p = toBox2d3(startPose(a).inverse() * b.position);
        if (def.angle) made.base.localFrameB.q = toRot(direction(-*def.angle));
        if (def.rate == 0) {
            made.linearVelocity = toBox2d3(startPose(a).rotation * def.velocity);
            made.angularVelocity = toSingle(def.angularVelocity);
            made.maxVelocityForce = toSingleAtMost(def.maxForce);
            made.maxVelocityTorque = toSingleAtMost(def.maxTorque);
        } else {
            constexpr double damping = 100;  // gives way by 1 / (4 z^2 rate h) of what a limit without a spring would
            const double left = 1 - built_.subStep * def.rate;
            if (left <= 0) refuse(fmt::format("no rate as fast as its sub-step, {} /s", 1 / built_.subStep));
            const double hertz = damping * def.rate / left / std::numbers::pi;
            made.linearHertz = made.angularHertz = toSingle(hertz);
            made.linearDampingRatio = made.angularDampingRatio = toSingle(damping);
            made.maxSpringForce = toSingleAtMost(def.maxForce);
            made.maxSpringTorque = toSingleAtMost(def.maxTorque);
        }
        return b2CreateMotorJoint(built_.world, &made);
    }

    /// In Box2D 3, bodies are dragged by the spring of a motor joint, which is fixed to a static body.
    b2JointId operator()(const TargetJointDef& def) const {
        b2MotorJointDef made = b2DefaultMotorJointDef();
        base(made.base);
        const b2BodyDef ground = b2DefaultBodyDef();
        made.base.bodyIdA = b2CreateBody(built_.world, &ground);
        made.base.bodyIdB = built_.bodies[joint_.bodyB];
        made.base.localFrameA.p = toBox2d3(def.target);
        made.base.localFrameB.p = toBox2d3(joint_.localAnchorB);
        made.base.collideConnected = true;
        const Vec2 pull = def.target - def.anchor;
        const double mass = effectiveMass(built_.scene, joint_, pull.norm() > 0 ? Vec2(pull.normalized()) : down());
        const Frequency linear = frequencyOf(springOf(def, bodyDef(joint_.bodyB)), mass);
        made.linearHertz = toSingle(linear.hertz);
        made.linearDampingRatio = toSingle(linear.dampingRatio);
        made.maxSpringForce = toSingleAtMost(def.maxForce);
        return b2CreateMotorJoint(built_.world, &made);
    }

    b2JointId operator()(const FilterJointDef&) const {
        b2FilterJointDef made = b2DefaultFilterJointDef();
        place(made.base);
        return b2CreateFilterJoint(built_.world, &made);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Unsupported(fmt::format("joint {}: Box2D 3 has {}", built_.scene.joints[index_].name, what));
    }

    const BodyDef& bodyDef(std::size_t body) const { return built_.scene.bodies[body].def; }
    static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
    Vec2 axis() const { return startPose(bodyDef(joint_.bodyA)).rotation * joint_.localAxis; }
    Vec2 down() const {
        const Vec2& gravity = built_.scene.gravity;
        return gravity.norm() > 0 ? Vec2(gravity.normalized()) : Vec2(0, 1);
    }

    void base(b2JointDef& made) const {
        const Breaking breaking = breakingOf(joint_.def);
        made.userData = reinterpret_cast<void*>(static_cast<std::uintptr_t>(index_));
        made.forceThreshold = toSingleAtMost(breaking.force);
        made.torqueThreshold = toSingleAtMost(breaking.torque);
        made.collideConnected = joint_.collideConnected;
    }

    /// The joint's frame points to +x in A's frame, and in the same direction in B's frame as the bodies are now: so
    /// angles are counted from here.
    void place(b2JointDef& made) const { place(made, {1, 0}); }
    void placeAlong(b2JointDef& made) const { place(made, joint_.localAxis); }
    void place(b2JointDef& made, const Vec2& localAxis) const {
        base(made);
        made.bodyIdA = built_.bodies[joint_.bodyA];
        made.bodyIdB = built_.bodies[joint_.bodyB];
        const double turn = bodyDef(joint_.bodyA).angle - bodyDef(joint_.bodyB).angle;
        const Vec2 across(-localAxis.y(), localAxis.x());
        made.localFrameA = {toBox2d3(joint_.localAnchorA), toRot(localAxis)};
        made.localFrameB = {toBox2d3(joint_.localAnchorB), toRot(std::cos(turn) * localAxis + std::sin(turn) * across)};
    }

    void spring(auto& made, const std::optional<Spring>& spring, double mass) const {
        if (!spring) return;
        const Frequency frequency = frequencyOf(*spring, mass);
        made.enableSpring = true;
        made.hertz = toSingle(frequency.hertz);
        made.dampingRatio = toSingle(frequency.dampingRatio);
    }

    static void motor(auto& made, double speed, double most) {
        made.enableMotor = most > 0;
        made.motorSpeed = toSingle(speed);
    }

    static void limit(auto& made, const std::optional<Limit>& limit, double rest = 0) {
        if (!limit) return;
        made.enableLimit = true;
        made.lowerTranslation = toSingle(std::max(limit->lower - rest, -farAway));
        made.upperTranslation = toSingle(std::min(limit->upper - rest, farAway));
    }

    const Built3& built_;
    const JointGeometry& joint_;
    std::size_t index_;
};

}  // namespace

b2JointId addJoint3(const Built3& built, const JointGeometry& joint, std::size_t index) {
    return std::visit(Joiner(built, joint, index), joint.def);
}

std::size_t jointOf3(const void* userData) {
    return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(userData));
}

}  // namespace plumb::compare
