// SPDX-License-Identifier: MIT
#include <plumb/shapes/tile.h>

#include <algorithm>

namespace plumb {

namespace {

std::vector<Vec2> uprightCorners(TileForm form) {
    switch (form) {
        case TileForm::Empty: return {};
        case TileForm::Full: return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        case TileForm::SlopeUp: return {{0, 0}, {1, 0}, {1, 1}};
        case TileForm::SlopeDown: return {{0, 0}, {1, 0}, {0, 1}};
        case TileForm::GentleUpLow: return {{0, 0}, {1, 0}, {1, 0.5}};
        case TileForm::GentleUpHigh: return {{0, 0}, {1, 0}, {1, 1}, {0, 0.5}};
        case TileForm::GentleDownHigh: return {{0, 0}, {1, 0}, {1, 0.5}, {0, 1}};
        case TileForm::GentleDownLow: return {{0, 0}, {1, 0}, {0, 0.5}};
    }
    return {};
}

}  // namespace

std::vector<Vec2> cornersOf(const Tile& tile) {
    std::vector<Vec2> corners = uprightCorners(tile.form);
    if (!tile.upsideDown) return corners;
    for (Vec2& corner : corners) corner.y() = 1 - corner.y();
    std::reverse(corners.begin(), corners.end());
    return corners;
}

}  // namespace plumb
