// SPDX-License-Identifier: MIT
// How are the shapes, contacts and joints of a world drawn over a game?
#pragma once
#include <games/frame/canvas.h>
#include <games/frame/footer.h>
#include <plumb/dynamics/world.h>

namespace plumb::games {

struct DebugView {
    bool shapes = true;      ///< outlines; the colour shows the kind of body, and whether it sleeps
    bool boxes = true;       ///< axis-aligned bounding boxes
    bool contacts = true;    ///< points, and normals that are longer for a stronger force
    bool joints = true;      ///< from body to body, over pulleys, to targets
    bool velocities = true;  ///< of the centres of mass: the way that they move in a fifth of a second
};

/// Draws over the game with the last camera, in debugLayer: above all layers of a game except its hudLayer.
void drawDebug(Canvas& canvas, const World& world, const DebugView& view = {});

/// Counts and energy, for the footer below the picture.
FooterLine figuresOf(const World& world);

}  // namespace plumb::games
