// SPDX-License-Identifier: MIT
// Which bodies are held together, and how?
#pragma once
#include <optional>
#include <variant>

#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>

namespace plumb {

/// A hinge: the two bodies share a point and turn freely about it, unless a motor turns B against A.
struct RevoluteJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchor{0, 0};          ///< the hinge, in the world, where the bodies stand now [m]
    double motorSpeed = 0;      ///< of B against A, that the motor is to reach [rad/s]
    double maxMotorTorque = 0;  ///< what it may use for that, >= 0, infinite for as much as it takes; 0: no motor [N m]
    bool collideConnected = false;  ///< may the two bodies touch each other?
};

/// A massless rod: two points stay at one distance.
struct DistanceJointDef {
    BodyId bodyA = {}, bodyB = {};
    Vec2 anchorA{0, 0};                           ///< on bodyA, in the world, where it stands now [m]
    Vec2 anchorB{0, 0};                           ///< on bodyB, in the world, where it stands now [m]
    std::optional<double> length = std::nullopt;  ///< > 0; without it, how far apart the anchors are now [m]
    bool collideConnected = false;                ///< may the two bodies touch each other?
};

using JointDef = std::variant<RevoluteJointDef, DistanceJointDef>;

}  // namespace plumb
