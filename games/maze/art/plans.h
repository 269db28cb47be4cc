// SPDX-License-Identifier: MIT
// Which cells do the cats go to?
#pragma once
#include <games/frame/canvas.h>
#include <games/maze/chase.h>

namespace plumb::games::maze {

/// For the debug view: the cells of the mouse and of the cats in the lanes, and a line from each hunting cat to its
/// target cell. Cats that are frightened, caught or at home have no target.
void drawPlans(Canvas& canvas, const Chase& chase);

}  // namespace plumb::games::maze
