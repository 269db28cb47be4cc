// SPDX-License-Identifier: MIT
// How far is it from any place in a level to the beacon?
#pragma once
#include <vector>

#include <games/runner/level.h>

namespace plumb::games::runner {

/// The length of a way through the air, around ground, thorns and water, as if the hero could fly. It guides findWay().
class WayField {
public:
    explicit WayField(const Level& level);

    double distance(const Vec2& from) const;  ///< large where there is no way [m]

private:
    double& at(Cell cell) { return distance_[index(cell)]; }
    std::size_t index(Cell cell) const { return static_cast<std::size_t>(cell.row * tiles_.columns() + cell.column); }
    bool isOpen(Cell cell) const;
    bool isOpenBetween(Cell from, Cell to) const;
    Cell inside(Cell cell) const;

    TileMap tiles_;
    std::vector<double> distance_;
};

}  // namespace plumb::games::runner
