// SPDX-License-Identifier: MIT
// Which shapes can be collided side by side? Boxes that lie straight in their body's frame, and discs. Any other is in
// a box of that kind, which tells what it cannot touch.
#pragma once
#include <cstdint>

#include <plumb/space/shape_def.h>

namespace plumb {

/// A shape as the lanes see it: inside a box with a radius around it.
struct BoxOutline {
    enum class Kind : std::uint8_t {
        Other,    ///< somewhere in there
        Rounded,  ///< all of it, and without a radius no area: a rounded box, a capsule or a line that lies straight
        Box,      ///< all of it, without a radius
        Disc,     ///< all of it, without a box
    };
    Kind kind = Kind::Other;
    bool sensor = false;
    float halfX = 0, halfY = 0;      ///< [m]
    float radius = 0;                ///< [m]
    float centerX = 0, centerY = 0;  ///< from the body's centre of mass [m]
    float restitution = 0;           ///< of the shape's material [-]
};
BoxOutline boxOutlineOf(const ShapeDef& shape, const Vec2& centerOfMass);

}  // namespace plumb
