// SPDX-License-Identifier: MIT
// What are the position and the velocity of a point?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct PointMotion {
    Vec2 position{0, 0};  ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// The same along one axis, or for an angle in rad.
struct AxisMotion {
    double position = 0;  ///< [m]
    double velocity = 0;  ///< [m/s]
};

}  // namespace plumb
