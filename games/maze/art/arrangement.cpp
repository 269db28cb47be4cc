// SPDX-License-Identifier: MIT
#include <games/maze/art/arrangement.h>

#include <algorithm>

#include <games/maze/art/hedges.h>

namespace plumb::games::maze {
namespace {

constexpr double bands = 162;      ///< of the displays above and below the maze, together [units of the screen]
constexpr double leastGain = 1.2;  ///< a maze that grows less stays between its displays

}  // namespace

Arrangement arrangementIn(const Aabb& screen) {
    const Arrangement wide{.top = 0, .bottom = screenHeight};
    const double height = screen.upper.y() - screen.lower.y();
    const double tile = std::min(screenWidth / gardenSize.x(), (height - bands) / gardenSize.y());
    if (tile < leastGain * screenHeight / wide.rows) return wide;
    const double half = tile * gardenSize.y() / 2, middle = (screen.upper.y() + screen.lower.y()) / 2;
    return {.upright = true, .rows = screenHeight / tile, .top = middle - half, .bottom = middle + half};
}

}  // namespace plumb::games::maze
