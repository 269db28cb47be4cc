// SPDX-License-Identifier: MIT
// Which bodies are held together, and how?
//
// A joint is defined at the bodies' present positions: anchors and axes are in world coordinates, and angles and shifts
// count from the present pose.
// Anchors lie within 1e5 m of their bodies' centres of mass. Other positions, angles, lengths, ratios, rates and speeds
// are at most 1e15; beyond that a body would be put in quarantine. Forces of 1e40 or more count as infinite.
// A value that could do nothing is refused: a motorSpeed while the motor's greatest torque or force is 0, and a rest
// position, a length or a motor that needs a spring where there is none. Joint::set may switch a motor off later.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>

namespace plumb {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Pulls back with stiffness times the stretch, plus damping times the stretching speed. Without damping it keeps its
/// energy.
struct Spring {
    double stiffness = 0;  ///< >= 0 [N/m]; for turning [N m/rad]
    double damping = 0;    ///< >= 0 [N s/m]; for turning [N m s/rad]
};

/// The spring on which a mass [kg] swings freely at a frequency [Hz]; a damping ratio of 1 just brings it to rest
/// without swinging. For turning, mass is the moment of inertia [kg m^2].
/// k = m (2 pi f)^2, c = 2 z m (2 pi f). Throws std::invalid_argument unless all are finite, and none is negative.
Spring springOf(double frequency, double dampingRatio, double mass);

/// The range of a joint's coordinate, counted from the pose when the joint is made. lower <= upper is required; 0 may
/// lie outside.
struct Limit {
    double lower = 0, upper = 0;  ///< [m]; for turning [rad]; may be infinite
};

/// A joint breaks, with an event, in the first step in which its load exceeds this.
struct Breaking {
    double force = unlimited;   ///< > 0 [N]
    double torque = unlimited;  ///< > 0 [N m]
};

/// A hinge: the two bodies share a point and turn about it.
struct RevoluteJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                            ///< the hinge [m]
    std::optional<Limit> limit = std::nullopt;    ///< of B's angle relative to A [rad]
    std::optional<Spring> spring = std::nullopt;  ///< turns B back to restAngle
    double restAngle = 0;                         ///< of B relative to A, counted from the present angle [rad]
    double motorSpeed = 0;                        ///< the motor's target speed, of B relative to A [rad/s]
    double maxMotorTorque = 0;      ///< the motor's greatest torque, >= 0, may be infinite; 0: no motor [N m]
    bool collideConnected = false;  ///< may the two bodies touch each other?
    Breaking breaking = {};
};

/// A slide: B moves along an axis of A, and does not turn relative to A.
struct PrismaticJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                            ///< where the force acts on both [m]
    Vec2 axis{1, 0};                              ///< fixed to A; any length but 0 [-]
    std::optional<Limit> limit = std::nullopt;    ///< of B's shift along the axis [m]
    std::optional<Spring> spring = std::nullopt;  ///< pulls B back to restShift
    double restShift = 0;                         ///< along the axis, from the present position [m]
    double motorSpeed = 0;                        ///< the motor's target speed, of B along the axis [m/s]
    double maxMotorForce = 0;                     ///< >= 0, may be infinite; 0: no motor [N]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// Keeps two points at a distance: a massless rod, or a spring; with a spring of zero stiffness and a maxLength, a
/// rope.
struct DistanceJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchorA{0, 0};                           ///< on bodyA [m]
    Vec2 anchorB{0, 0};                           ///< on bodyB [m]
    std::optional<double> length = std::nullopt;  ///< > 0; without it, the anchors' present distance [m]
    std::optional<Spring> spring = std::nullopt;  ///< without it, a rod
    double minLength = 0;                         ///< with a spring: no shorter than this, >= 0 [m]
    double maxLength = unlimited;                 ///< with a spring: no longer than this, >= minLength [m]
    double motorSpeed = 0;                        ///< with a spring: the motor's target speed of lengthening [m/s]
    double maxMotorForce = 0;                     ///< >= 0, may be infinite; 0: no motor [N]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// Holds two bodies together, rigidly or with springs.
struct WeldJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                             ///< where the force acts on both [m]
    std::optional<Spring> spring = std::nullopt;   ///< between the anchors; without it, they are held rigidly
    std::optional<Spring> bending = std::nullopt;  ///< of the angle; without it, the angle is held rigidly
    bool collideConnected = false;
    Breaking breaking = {};
};

/// A wheel, B, on the suspension of a car, A: it turns freely, and moves along an axis of A.
struct WheelJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                            ///< the wheel's hub [m]
    Vec2 axis{0, 1};                              ///< of the suspension, fixed to A; any length but 0 [-]
    std::optional<Limit> limit = std::nullopt;    ///< of the hub's shift along the axis [m]
    std::optional<Spring> spring = std::nullopt;  ///< pulls the hub back to restShift; without it, it slides freely
    double restShift = 0;                         ///< along the axis, from the present position [m]
    double motorSpeed = 0;                        ///< the motor's target speed, of B relative to A [rad/s]
    double maxMotorTorque = 0;                    ///< >= 0, may be infinite; 0: no motor [N m]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// A rope over two fixed wheels without weight or friction: lengthA + ratio lengthB never exceeds its present value.
/// The rope may become slack.
struct PulleyJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 groundA{0, 0};  ///< the wheel over bodyA, fixed in the world [m]
    Vec2 groundB{0, 0};  ///< the wheel over bodyB [m]
    Vec2 anchorA{0, 0};  ///< on bodyA [m]
    Vec2 anchorB{0, 0};  ///< on bodyB [m]
    double ratio = 1;    ///< of a block and tackle: A rises by ratio times the descent of B, > 0 [-]
    bool collideConnected = true;
    Breaking breaking = {};
};

/// Couples two joints, each revolute or prismatic: a + ratio b keeps its present value, a and b their angles or shifts.
/// The gear is removed with either of the two joints.
struct GearJointDef {
    JointId jointA = {}, jointB = {};
    double ratio =
        1;  ///< not 0; for two hinges on a common base, teeth of B over teeth of A [-], with a slide [m] or [1/m]
    Breaking breaking = {};
};

/// Holds B at a pose relative to A, or moves it at a velocity, with a bounded force: an actuator, or, at a rate of 0,
/// the friction of the ground in a view from above.
struct MotorJointDef {
    BodyId bodyA = {}, bodyB = {};
    std::optional<Vec2> offset = std::nullopt;   ///< of B's origin in A's frame; without it, the present one [m]
    std::optional<double> angle = std::nullopt;  ///< of B relative to A; without it, the present one [rad]
    double rate = 10;                            ///< share of the error that it corrects per second, >= 0 [1/s]
    Vec2 velocity{0, 0};                         ///< of B relative to A, in A's frame, added to the correction [m/s]
    double angularVelocity = 0;                  ///< [rad/s]
    double maxForce = 0;                         ///< >= 0, may be infinite [N]
    double maxTorque = 0;                        ///< >= 0, may be infinite [N m]
    bool collideConnected = true;
    Breaking breaking = {};
};

/// Drags a point of a body to a point of the world, as a mouse does.
struct TargetJointDef {
    BodyId body = {};
    Vec2 anchor{0, 0};                            ///< on the body [m]
    Vec2 target{0, 0};                            ///< where the anchor should go [m]
    std::optional<Spring> spring = std::nullopt;  ///< without it, 5 Hz of the body's mass at a damping ratio of 0.7
    double maxForce = unlimited;                  ///< >= 0 [N]
    Breaking breaking = {};
};

/// Keeps two bodies from ever touching each other.
struct FilterJointDef {
    BodyId bodyA = {}, bodyB = {};
};

using JointDef = std::variant<RevoluteJointDef, PrismaticJointDef, DistanceJointDef, WeldJointDef, WheelJointDef,
                              PulleyJointDef, GearJointDef, MotorJointDef, TargetJointDef, FilterJointDef>;

namespace detail {

/// What braces without the name of a joint could mean: its members in the order of all definitions. No joint is made
/// from it.
struct JointOfNoKind {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0}, axis{1, 0}, groundA{0, 0}, groundB{0, 0}, anchorA{0, 0}, anchorB{0, 0};
    std::optional<double> length = std::nullopt;
    double ratio = 1;
    std::optional<Limit> limit = std::nullopt;
    std::optional<Spring> spring = std::nullopt, bending = std::nullopt;
    double minLength = 0, maxLength = 0, restAngle = 0, restShift = 0, motorSpeed = 0, maxMotorTorque = 0,
           maxMotorForce = 0, maxForce = 0, maxTorque = 0;
    bool collideConnected = false;
    Breaking breaking = {};
};

}  // namespace detail

/// Throws std::invalid_argument that names the field, the value and what is allowed. Checks only what does not depend
/// on a world: not ids, nor the distance of anchors from their bodies. field: the name of the def itself.
void validate(const JointDef& def, const std::string& field);

}  // namespace plumb
