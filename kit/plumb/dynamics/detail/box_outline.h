// SPDX-License-Identifier: MIT
// Which shapes can be collided side by side? Boxes that are not rounded and lie straight in their body's frame. Any
// other is in a box of that kind, which tells what it cannot touch.
#pragma once
#include <plumb/space/shape_def.h>

namespace plumb {

/// A shape as the lanes see it: inside a box with a radius around it.
struct BoxOutline {
    bool exact = false;              ///< the shape is the box, and has no radius
    bool upright = false;            ///< the shape is the box and the radius: a disc, a capsule that lies straight, ...
    float halfX = 0, halfY = 0;      ///< [m]
    float radius = 0;                ///< [m]
    float centerX = 0, centerY = 0;  ///< from the body's centre of mass [m]
    float restitution = 0;           ///< of the shape's material [-]
};
BoxOutline boxOutlineOf(const ShapeDef& shape, const Vec2& centerOfMass);

}  // namespace plumb
