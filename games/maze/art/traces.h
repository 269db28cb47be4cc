// SPDX-License-Identifier: MIT
// How are recent events drawn?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

struct Trace;

/// Draws flying crumbs, rings of light, stars and rising points, or nothing for events without an effect. In tiles.
void drawTrace(Canvas& canvas, const Trace& trace);

}  // namespace plumb::games::maze
