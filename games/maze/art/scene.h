// SPDX-License-Identifier: MIT
// How is the whole game drawn?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

class MazeGame;

void drawScene(Canvas& canvas, const MazeGame& game);

}  // namespace plumb::games::maze
