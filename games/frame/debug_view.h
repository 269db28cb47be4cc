// SPDX-License-Identifier: MIT
// What does the kit see where a game draws?
#pragma once
#include <games/frame/canvas.h>
#include <games/frame/footer.h>
#include <plumb/dynamics/world.h>

namespace plumb::games {

struct DebugView {
    bool shapes = true;      ///< outlines, by kind of body and sleep
    bool boxes = true;       ///< upright bounding boxes
    bool contacts = true;    ///< points, and normals, the longer the stronger the force
    bool joints = true;      ///< from body to body, over pulleys, to targets
    bool velocities = true;  ///< of the centres of mass, so far as they move in a fifth of a second
};

/// Over what was drawn, by the camera last looked through, in a layer above all that a game has but its hudLayer.
void drawDebug(Canvas& canvas, const World& world, const DebugView& view = {});

/// Counts and energy, to be told below the picture.
FooterLine figuresOf(const World& world);

}  // namespace plumb::games
