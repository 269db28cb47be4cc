// SPDX-License-Identifier: MIT
// How does the player look?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

struct MousePose {
    double angle = 0;   ///< of its nose, from +x towards +y [rad]
    double stride = 0;  ///< how far it has run; feet and tail go by that [tiles]
    bool still = false;
    bool blinks = false;
};

/// From above, its middle at (0, 0), about 1.6 long without the tail. Place it with Canvas.place.
void drawMouse(Canvas& canvas, const MousePose& pose);
/// Caught: share 0 to 1 of the time that it takes to be gone.
void drawLostMouse(Canvas& canvas, double angle, double share);

}  // namespace plumb::games::maze
