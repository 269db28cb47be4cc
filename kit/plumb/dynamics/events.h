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
    std::optional<Cell> tile = std::nullopt;  ///< of the tile map, if one of the two is one
};

/// A shape of one body and a shape of another ceased to touch, also because one was removed before the step. An id may
/// be of what was removed.
struct ContactEnd {
    ShapeId shapeA, shapeB;
};

/// Two shapes, touching before or not, came together faster than WorldDef.hitSpeed.
struct ContactHit {
    ShapeId shapeA, shapeB;
    Vec2 point{0, 0};                         ///< where, in the world [m]
    Vec2 normal{0, 1};                        ///< from A to B [-]
    double approachSpeed = 0;                 ///< along the normal [m/s]
    std::optional<Cell> tile = std::nullopt;  ///< of the tile map, if one of the two is one
};

/// A shape came into a sensor, or began to overlap it where it stands: seen at the step's end. What passes right
/// through a sensor within a step begins and ends in it. Neither of two sensors is told of the other, nor is a static
/// sensor of what is static; filters and groups count as for a touch.
struct SensorBegin {
    ShapeId sensor, visitor;
};

/// A shape left a sensor, also because one of the two was removed. An id may be of what was removed.
struct SensorEnd {
    ShapeId sensor, visitor;
};

/// Where a body is that was awake in the step.
struct BodyMoved {
    BodyId body;
    Transform pose;           ///< local to world
    bool fellAsleep = false;  ///< at the step's end
};

/// A joint bore more than its Breaking allows, and was removed, with what hung on it.
struct JointBroke {
    JointId joint;
    BodyId bodyA, bodyB;
    Vec2 force{0, 0};   ///< that it bore, on bodyB [N]
    double torque = 0;  ///< [N m]
};

/// A body left the range of finite numbers. It was put back to where it was before, and stays there, disabled.
struct Quarantined {
    BodyId body;
};

}  // namespace plumb
