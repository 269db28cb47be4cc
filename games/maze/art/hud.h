// SPDX-License-Identifier: MIT
// What is shown beside the maze?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

class MazeGame;

/// In the screen's units: score, level, fright and lives on the left, the cats and the treats eaten on the right.
void drawHud(Canvas& canvas, const MazeGame& game);

}  // namespace plumb::games::maze
