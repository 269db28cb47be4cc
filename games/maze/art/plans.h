// SPDX-License-Identifier: MIT
// What do the cats want?
#pragma once
#include <games/frame/canvas.h>
#include <games/maze/chase.h>

namespace plumb::games::maze {

/// For the debug view: the cells that all are in, and, for each cat that hunts, a line to the cell that it makes for.
/// Whoever is afraid or at home makes for none.
void drawPlans(Canvas& canvas, const Chase& chase);

}  // namespace plumb::games::maze
