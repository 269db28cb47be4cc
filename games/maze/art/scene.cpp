// SPDX-License-Identifier: MIT
#include <games/maze/art/scene.h>

#include <games/maze/maze_game.h>

namespace plumb::games::maze {

void drawScene(Canvas& canvas, const MazeGame&) {
    canvas.clear(Color{});
}

}  // namespace plumb::games::maze
