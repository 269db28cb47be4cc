// SPDX-License-Identifier: MIT
// Where are the displays of the maze: beside it, or, in an upright window, above and below it?
#pragma once
#include <games/frame/camera.h>

namespace plumb::games::maze {

struct Arrangement {
    bool upright = false;
    double rows = 32.4;          ///< the height of the safe area, in rows of the maze
    double top = 0, bottom = 0;  ///< of the maze [units of the screen]
};

/// The maze is as large as the window and its displays allow. screen: the visible part, in units of the screen.
Arrangement arrangementIn(const Aabb& screen);

}  // namespace plumb::games::maze
