// SPDX-License-Identifier: MIT
// Where are the displays of the maze: beside it, or, in an upright window, above and below it?
#pragma once
#include <algorithm>

#include <games/frame/camera.h>
#include <games/maze/art/hedges.h>

namespace plumb::games::maze {

struct Arrangement {
    bool upright = false;
    double rows = 32.4;          ///< the height of the safe area, in rows of the maze
    double top = 0, bottom = 0;  ///< of the maze [units of the screen]
};

/// The maze is as large as the window and its displays allow. screen: the visible part, in units of the screen.
inline Arrangement arrangementIn(const Aabb& screen) {
    constexpr double bands = 162;      ///< of the displays above and below the maze, together [units of the screen]
    constexpr double leastGain = 1.2;  ///< a maze that grows less stays between its displays
    const Arrangement wide{.top = 0, .bottom = screenHeight};
    const double height = screen.upper.y() - screen.lower.y();
    const double tile = std::min(screenWidth / gardenSize.x(), (height - bands) / gardenSize.y());
    if (tile < leastGain * screenHeight / wide.rows) return wide;
    const double half = tile * gardenSize.y() / 2, middle = (screen.upper.y() + screen.lower.y()) / 2;
    return {.upright = true, .rows = screenHeight / tile, .top = middle - half, .bottom = middle + half};
}

}  // namespace plumb::games::maze
