// SPDX-License-Identifier: MIT
// What is shown beside the maze, or above and below it?
#pragma once
#include <games/frame/canvas.h>
#include <games/maze/art/arrangement.h>

namespace plumb::games::maze {

class MazeGame;

/// In the screen's units: score, level, fright and lives on the left, the cats and the treats eaten on the right. In an
/// upright window the cats and the fright are below the maze, and the rest is above it.
void drawHud(Canvas& canvas, const MazeGame& game, const Arrangement& arrangement);

}  // namespace plumb::games::maze
