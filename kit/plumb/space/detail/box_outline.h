// SPDX-License-Identifier: MIT
// Which shapes can be collided several pairs at a time? Boxes that are parallel to the axes of their body's frame, and
// discs. Any other shape gets a bounding box of that kind, which shows what it cannot touch.
#pragma once
#include <cstdint>

#include <plumb/space/shape_def.h>

namespace plumb {

/// A shape as a box with a rounding radius, for the lanes of the narrow phase.
struct BoxOutline {
    enum class Kind : std::uint8_t {
        Other,    ///< the shape is only contained in the box
        Rounded,  ///< the shape equals the rounded box: a rounded box, or a capsule or line parallel to an axis
        Box,      ///< the shape equals the box; the radius is 0
        Disc,     ///< the shape equals the rounding; the half sizes are 0
    };
    Kind kind = Kind::Other;
    bool sensor = false;
    bool chained = false;            ///< a segment with neighbours: its contacts depend on them, too
    std::uint8_t corners = 0;        ///< number of corners of a polygon that is collided in lanes; else 0
    float halfX = 0, halfY = 0;      ///< [m]
    float radius = 0;                ///< [m]
    float centerX = 0, centerY = 0;  ///< from the body's centre of mass [m]
    float restitution = 0;           ///< of the shape's material [-]
};
BoxOutline boxOutlineOf(const ShapeDef& shape, const Vec2& centerOfMass);

}  // namespace plumb
