// SPDX-License-Identifier: MIT
// Which shapes lie along a line, or near or within an outline?
#pragma once
#include <optional>

#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// Where a ray, or a shape that moves along a straight line, meets a shape first. A ray of zero length, or a shape with
/// a zero shift, meets the shapes that it is in or touches; the normal is then the nearest way out.
struct CastHit {
    ShapeId shape;
    Vec2 point{0, 0};     ///< where they meet, in the world [m]
    Vec2 normal{0, 1};    ///< outward from the shape that was met; against the motion if it began inside [-]
    double fraction = 0;  ///< of the way, 0 to 1; 0 if it began inside or touching [-]
    std::optional<Vec2> oneWay = std::nullopt;  ///< if one-way: the only side, in the world, from which it is solid
    std::optional<Cell> tile = std::nullopt;    ///< the cell, if a tile map was met
};

/// The shape nearest to something.
struct Nearest {
    ShapeId shape;
    double separation = 0;  ///< negative inside it [m]
    Vec2 point{0, 0};       ///< the nearest point of the shape, in the world [m]
    Vec2 normal{0, 1};      ///< from the shape to the point of the query [-]
};

}  // namespace plumb
