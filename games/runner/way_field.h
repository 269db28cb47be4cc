// SPDX-License-Identifier: MIT
// How far is it from anywhere in a level to its beacon?
#pragma once
#include <vector>

#include <games/runner/level.h>

namespace plumb::games::runner {

/// Through the air, around all that is solid, thorns or water, as if one could fly: a hint for who looks for a way.
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
