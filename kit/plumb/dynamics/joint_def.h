// SPDX-License-Identifier: MIT
// Which bodies are held together, and how?
//
// A joint is given where the bodies stand now: anchors and axes in the world, and angles and shifts counted from here.
// Anchors lie within 1e5 m of their bodies' centres of mass; other places, angles, lengths, ratios, rates and speeds
// within 1e15, beyond which a body would be put in quarantine. Forces of 1e40 or more are as good as infinite.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>

namespace plumb {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Pulls back by stiffness times how far off, and damping times how fast. Without damping it keeps its energy.
struct Spring {
    double stiffness = 0;  ///< >= 0 [N/m], of what turns [N m/rad]
    double damping = 0;    ///< >= 0 [N s/m], of what turns [N m s/rad]
};

/// The spring on which a mass [kg] swings freely at a frequency [Hz]; a damping ratio of 1 just brings it to rest
/// without swinging. Of what turns, mass is the moment of inertia [kg m^2].
/// k = m (2 pi f)^2, c = 2 z m (2 pi f). Throws std::invalid_argument unless all are finite, and none is negative.
Spring springOf(double frequency, double dampingRatio, double mass);

/// How far a joint may go, from where it is when it is made: lower <= 0 <= upper need not hold, lower <= upper must.
struct Limit {
    double lower = 0, upper = 0;  ///< [m], of what turns [rad]; may be infinite
};

/// A joint breaks, with an event, in the first step in which it bears more than this.
struct Breaking {
    double force = unlimited;   ///< > 0 [N]
    double torque = unlimited;  ///< > 0 [N m]
};

/// A hinge: the two bodies share a point and turn about it.
struct RevoluteJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                          ///< the hinge [m]
    double motorSpeed = 0;                      ///< of B against A, that the motor is to reach [rad/s]
    double maxMotorTorque = 0;                  ///< what it may use for that, >= 0, may be infinite; 0: no motor [N m]
    std::optional<Limit> limit = std::nullopt;  ///< of B's angle against A's [rad]
    std::optional<Spring> spring = std::nullopt;  ///< turns B back to restAngle
    double restAngle = 0;                         ///< of B against A, from how they are turned now [rad]
    bool collideConnected = false;                ///< may the two bodies touch each other?
    Breaking breaking = {};
};

/// A slide: B moves along an axis of A, and does not turn against it.
struct PrismaticJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                            ///< where the force acts on both [m]
    Vec2 axis{1, 0};                              ///< fixed to A; any length but 0 [-]
    double motorSpeed = 0;                        ///< of B along the axis, that the motor is to reach [m/s]
    double maxMotorForce = 0;                     ///< >= 0, may be infinite; 0: no motor [N]
    std::optional<Limit> limit = std::nullopt;    ///< of B's shift along the axis [m]
    std::optional<Spring> spring = std::nullopt;  ///< pulls B back to restShift
    double restShift = 0;                         ///< along the axis, from where they are now [m]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// Two points at a distance: a massless rod, or a spring between them, or, with a spring of no stiffness and a limit, a
/// rope.
struct DistanceJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchorA{0, 0};                           ///< on bodyA [m]
    Vec2 anchorB{0, 0};                           ///< on bodyB [m]
    std::optional<double> length = std::nullopt;  ///< > 0; without it, how far apart the anchors are now [m]
    std::optional<Spring> spring = std::nullopt;  ///< without it, a rod
    double minLength = 0;                         ///< with a spring: no shorter than this, >= 0 [m]
    double maxLength = unlimited;                 ///< with a spring: no longer than this, >= minLength [m]
    double motorSpeed = 0;                        ///< with a spring: at which a motor is to lengthen it [m/s]
    double maxMotorForce = 0;                     ///< >= 0, may be infinite; 0: no motor [N]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// Two bodies as one, or nearly so.
struct WeldJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                             ///< where the force acts on both [m]
    std::optional<Spring> spring = std::nullopt;   ///< of the anchor; without it, it does not give
    std::optional<Spring> bending = std::nullopt;  ///< of the angle; without it, it does not give
    bool collideConnected = false;
    Breaking breaking = {};
};

/// A wheel, B, on the suspension of a car, A: it turns freely, and moves along an axis of A.
struct WheelJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};                            ///< the wheel's hub [m]
    Vec2 axis{0, 1};                              ///< of the suspension, fixed to A; any length but 0 [-]
    double motorSpeed = 0;                        ///< of B against A, that the motor is to reach [rad/s]
    double maxMotorTorque = 0;                    ///< >= 0, may be infinite; 0: no motor [N m]
    std::optional<Limit> limit = std::nullopt;    ///< of the hub's shift along the axis [m]
    std::optional<Spring> spring = std::nullopt;  ///< pulls the hub back to restShift; without it, it slides freely
    double restShift = 0;                         ///< along the axis, from where it is now [m]
    bool collideConnected = false;
    Breaking breaking = {};
};

/// A rope over two fixed wheels without weight or friction: lengthA + ratio lengthB stays what it is now; what hangs on
/// it may come up slack.
struct PulleyJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 groundA{0, 0};  ///< the wheel over bodyA, fixed in the world [m]
    Vec2 groundB{0, 0};  ///< the wheel over bodyB [m]
    Vec2 anchorA{0, 0};  ///< on bodyA [m]
    Vec2 anchorB{0, 0};  ///< on bodyB [m]
    double ratio = 1;    ///< of a block and tackle: A comes up by ratio times what B goes down, > 0 [-]
    bool collideConnected = true;
    Breaking breaking = {};
};

/// Two joints, each revolute or prismatic, of which one drives the other: a + ratio b stays what it is now, a and b
/// their angles or shifts. Removed with either.
struct GearJointDef {
    JointId jointA = {}, jointB = {};
    double ratio =
        1;  ///< not 0; for two hinges on a common base, teeth of B over teeth of A [-], with a slide [m] or [1/m]
    Breaking breaking = {};
};

/// Holds B to a pose against A, or moves it at a velocity, with no more than so much force: an actuator, or, at a rate
/// of 0, the friction of what is seen from above.
struct MotorJointDef {
    BodyId bodyA = {}, bodyB = {};
    std::optional<Vec2> offset = std::nullopt;   ///< of B's origin in A's frame; without it, where it is now [m]
    std::optional<double> angle = std::nullopt;  ///< of B against A; without it, as it is now [rad]
    double rate = 10;                            ///< the share of its error that it takes back in a second, >= 0 [1/s]
    Vec2 velocity{0, 0};                         ///< of B against A, in A's frame, beside that [m/s]
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
    Vec2 target{0, 0};                            ///< where it is to go [m]
    std::optional<Spring> spring = std::nullopt;  ///< without it, 5 Hz of the body's mass at a damping ratio of 0.7
    double maxForce = unlimited;                  ///< >= 0 [N]
    Breaking breaking = {};
};

/// These two never touch each other.
struct FilterJointDef {
    BodyId bodyA = {}, bodyB = {};
};

using JointDef = std::variant<RevoluteJointDef, PrismaticJointDef, DistanceJointDef, WeldJointDef, WheelJointDef,
                              PulleyJointDef, GearJointDef, MotorJointDef, TargetJointDef, FilterJointDef>;

/// Throws std::invalid_argument naming the field, the value and what was wanted, as far as no world is needed to tell:
/// ids are not looked at, nor how far anchors are from their bodies. field is the name of the def itself.
void validate(const JointDef& def, const std::string& field);

}  // namespace plumb
