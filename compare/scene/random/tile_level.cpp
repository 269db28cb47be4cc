// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/worlds.h>

namespace plumb::compare {
namespace {

constexpr int highestGround = 6;  // rows

/// A tile map drawn from left to right, with columns of wall at both ends.
class Level {
public:
    Level(Draw& draw, int columns, int rows, double size)
        : draw_(draw), map_({.columns = columns, .rows = rows, .size = size}) {
        frame();
    }

    /// Adds flat ground, stairs, or slopes up or down.
    void addGround() {
        int height = draw_.integer(1, 3), column = 1;
        while (column < map_.columns() - 1) {
            const int move = draw_.integer(0, 6);
            const bool isLow = height <= 1, isHigh = height >= highestGround;
            if (move == 1 && !isHigh) {
                slope(column++, height, TileForm::SlopeUp);
                ++height;
            } else if (move == 2 && !isLow) {
                --height;
                slope(column++, height, TileForm::SlopeDown);
            } else if (move == 3 && !isHigh && column + 2 < map_.columns()) {
                slope(column++, height, TileForm::GentleUpLow);
                slope(column++, height, TileForm::GentleUpHigh);
                ++height;
            } else if (move == 4 && !isLow && column + 2 < map_.columns()) {
                --height;
                slope(column++, height, TileForm::GentleDownHigh);
                slope(column++, height, TileForm::GentleDownLow);
            } else {
                if (move == 5 && !isHigh) ++height;
                if (move == 6 && !isLow) --height;
                fill(column++, height);
            }
        }
    }

    /// Adds rows of a few tiles in the air, at this many heights.
    void addPlatforms(int count, int storeys) {
        for (int i = 0; i < count; ++i) {
            const int row = highestGround + 2 + 3 * draw_.integer(0, storeys - 1);
            const int first = draw_.integer(2, map_.columns() - 3), length = draw_.integer(1, 6);
            const int last = std::min(first + length, map_.columns() - 2);
            for (int column = first; column < last; ++column) put(column, row, TileForm::Full);
        }
    }

    const TileMap& map() const { return map_; }

private:
    void put(int column, int row, TileForm form) { map_.set({column, row}, {.form = form}); }
    void fill(int column, int height) {
        for (int row = 0; row < height; ++row) put(column, row, TileForm::Full);
    }
    void slope(int column, int height, TileForm form) {
        fill(column, height);
        put(column, height, form);
    }
    void frame() {
        for (int row = 0; row < map_.rows(); ++row)
            for (const int column : {0, map_.columns() - 1}) put(column, row, TileForm::Full);
        for (int column = 0; column < map_.columns(); ++column) put(column, map_.rows() - 1, TileForm::Full);
    }

    Draw& draw_;
    TileMap map_;
};

}  // namespace

std::string fillTiles(Scene& scene, Draw& draw, const Filling& filling) {
    const double wanted = std::sqrt(areaOf(filling.items) * draw.logUniform(1.5, 5));
    const double width = std::max(wanted, 2 * widestOf(filling.items) + 4);
    const double size = std::clamp(width / draw.integer(20, 50), 0.5, 2.0);
    const int columns = static_cast<int>(width / size) + 3, storeys = draw.integer(1, 3);
    const double half = (columns - 2) * size / 2;
    const double bottom = size * (highestGround + 3 * storeys + 1);
    const std::vector<Vec2> origins = placeOver(filling.items, {-half, half}, bottom, draw);
    const double top = addItems(scene, filling.items, origins);
    Level level(draw, columns, static_cast<int>((top + headroom) / size) + 2, size);
    level.addGround();
    level.addPlatforms(draw.integer(0, columns / 4), storeys);
    setWorld(scene, {tiles(level.map(), {.friction = 0.6})});
    scene.bodies.front().def.position = {-half - size, 0};
    return "in a level of tiles";
}

}  // namespace plumb::compare
