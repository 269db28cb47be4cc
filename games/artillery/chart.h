// SPDX-License-Identifier: MIT
// Where is everybody on the island, when the picture shows only a part of it?
#pragma once
#include <games/artillery/arrangement.h>
#include <games/artillery/battle.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

/// A small picture of the island with its gunners, the shell and a frame around what is seen, in units of the screen.
/// seen: the visible part of the world.
void drawChart(Canvas& canvas, const Battle& battle, const Palette& palette, const Aabb& seen, double top);

}  // namespace plumb::games::artillery
