// SPDX-License-Identifier: MIT
// What lies along a line, or within an outline?
#pragma once
#include <optional>

#include <plumb/dynamics/id.h>
#include <plumb/math/vec2.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// Where a ray, or a shape that moves straight on, meets a shape first. A ray of no length, or a shape that is shifted
/// by nothing, meets what it is in or touches; the normal is then the nearest way out.
struct CastHit {
    ShapeId shape;
    Vec2 point{0, 0};     ///< where they meet, in the world [m]
    Vec2 normal{0, 1};    ///< outward from what was met; where it began inside, against the motion [-]
    double fraction = 0;  ///< of the way, 0 to 1; 0 where it began inside or touching [-]
    std::optional<Vec2> oneWay = std::nullopt;  ///< it is solid to what comes from there alone, in the world
    std::optional<Cell> tile = std::nullopt;    ///< of the map that was met
};

/// The shape nearest to something.
struct Nearest {
    ShapeId shape;
    double separation = 0;  ///< negative inside it [m]
    Vec2 point{0, 0};       ///< the nearest of the shape, in the world [m]
    Vec2 normal{0, 1};      ///< from the shape to what was asked about [-]
};

}  // namespace plumb
