// SPDX-License-Identifier: MIT
// How is what has just happened still seen?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

struct Trace;

/// Crumbs that fly, rings of light, stars, and points that rise; nothing of what leaves no trace. In tiles.
void drawTrace(Canvas& canvas, const Trace& trace);

}  // namespace plumb::games::maze
