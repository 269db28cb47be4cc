// SPDX-License-Identifier: MIT
// How does the player look?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

struct MousePose {
    double angle = 0;   ///< of its nose, from +x towards +y [rad]
    double stride = 0;  ///< how far it has run; moves feet and tail [tiles]
    bool still = false;
    bool blinks = false;
};

/// Seen from above. Its middle is at (0, 0), and it is about 1.6 long without the tail. Place it with Canvas.place.
void drawMouse(Canvas& canvas, const MousePose& pose);
/// The caught mouse disappears. share: of the time that this takes, 0 to 1.
void drawLostMouse(Canvas& canvas, double angle, double share);

}  // namespace plumb::games::maze
