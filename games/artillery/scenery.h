// SPDX-License-Identifier: MIT
// How do sky, sea and earth look?
#pragma once
#include <games/artillery/battle.h>
#include <games/artillery/eye.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

/// Sky, sun, clouds, gulls or stars, far islands and the far sea, each with the parallax of its distance. drift: how
/// far the wind has blown so far [m].
void drawBackdrop(Canvas& canvas, const Camera& camera, const Palette& palette, double seconds, double drift);
/// These two use the canvas's current camera.
void drawEarth(Canvas& canvas, const Terrain& terrain, const Palette& palette);
void drawSea(Canvas& canvas, double level, const Palette& palette, double seconds);

}  // namespace plumb::games::artillery
