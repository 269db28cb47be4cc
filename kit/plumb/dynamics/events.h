// SPDX-License-Identifier: MIT
// What happened in the last step?
#pragma once
#include <optional>

#include <plumb/dynamics/id.h>
#include <plumb/math/transform.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// A shape of one body and a shape of another began to touch, or hit each other anew.
struct ContactBegin {
    ShapeId shapeA, shapeB;
    Vec2 point{0, 0};                         ///< where, in the world [m]
    Vec2 normal{0, 1};                        ///< from A to B [-]
    double approachSpeed = 0;                 ///< at which the points came together along the normal, >= 0 [m/s]
    std::optional<Cell> tile = std::nullopt;  ///< the touched cell, if one of the two shapes is a tile map
};

/// A shape of one body and a shape of another ceased to touch, also because one was removed before the step. An id may
/// belong to a removed shape.
struct ContactEnd {
    ShapeId shapeA, shapeB;
};

/// Two shapes, touching before or not, came together faster than WorldDef.hitSpeed.
struct ContactHit {
    ShapeId shapeA, shapeB;
    Vec2 point{0, 0};                         ///< where, in the world [m]
    Vec2 normal{0, 1};                        ///< from A to B [-]
    double approachSpeed = 0;                 ///< along the normal [m/s]
    std::optional<Cell> tile = std::nullopt;  ///< the touched cell, if one of the two shapes is a tile map
};

/// A shape entered a sensor, or a moving sensor began to overlap it. Overlap is checked at the step's end. A shape that
/// passes through a sensor within one step begins and ends in that step. Sensors do not see other sensors, and a static
/// sensor does not see static shapes; filters and groups apply as for contacts.
struct SensorBegin {
    ShapeId sensor, visitor;
};

/// A shape left a sensor, also because one of the two was removed. An id may belong to a removed shape.
struct SensorEnd {
    ShapeId sensor, visitor;
};

/// The pose of a body that was awake in the step.
struct BodyMoved {
    BodyId body;
    Transform pose;           ///< local to world
    bool fellAsleep = false;  ///< at the step's end
};

/// The load of a joint exceeded its Breaking. The joint was removed, with the gears that it drove.
struct JointBroke {
    JointId joint;
    BodyId bodyA, bodyB;
    Vec2 force{0, 0};   ///< load of the joint, on bodyB [N]
    double torque = 0;  ///< [N m]
};

/// A body left the range of finite numbers. It was put back to where it was before, and stays there, disabled.
struct Quarantined {
    BodyId body;
};

}  // namespace plumb
